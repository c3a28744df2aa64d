#pragma once
/// Runs commands as a user would: through a shell, with pipes, closed streams and terminals.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace soft::process {

namespace fs = std::filesystem;

struct Outcome {
    int code = -1;  ///< 128 + signal if it was killed
    std::string out, err;
};

inline std::string slurp(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream{path, std::ios::binary}.rdbuf();
    return text.str();
}

/// A temporary folder in which commands run; the destructor removes it.
class Folder {
public:
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "soft-cli-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const fs::path& path() const { return path_; }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream{path_ / name, std::ios::binary} << text;
    }

private:
    fs::path path_;
};

/// Runs `bash -c command` with `mesh-gen` on PATH; stdin is empty unless the command redirects it.
inline Outcome run(const Folder& folder, const std::string& command) {
    const fs::path out = fs::path{folder.path()} += ".out", err = fs::path{folder.path()} += ".err";
    const pid_t child = ::fork();
    if (child == 0) {
        ::setenv("PATH", (fs::path{MESH_GEN}.parent_path().string() + ":" + std::getenv("PATH")).c_str(), 1);
        ::unsetenv("NO_COLOR");
        const bool ready = ::chdir(folder.path().c_str()) == 0 && ::dup2(::open("/dev/null", O_RDONLY), 0) == 0 &&
                           ::dup2(::open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), 1) == 1 &&
                           ::dup2(::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), 2) == 2;
        if (ready) ::execlp("bash", "bash", "-c", command.c_str(), nullptr);
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), slurp(out), slurp(err)};
    fs::remove(out);
    fs::remove(err);
    return outcome;
}

/// Like run, with a terminal as the given stream (0, 1 or 2); `out` also contains the terminal output.
inline Outcome run_on_terminal(const Folder& folder, int stream, const std::string& command) {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    ::grantpt(terminal);
    ::unlockpt(terminal);
    const std::string name = ::ptsname(terminal);
    // Keep the terminal open: otherwise the written data are lost when the command ends.
    const int keep = ::open(name.c_str(), O_RDWR | O_NOCTTY);
    Outcome outcome = run(folder, "exec " + std::to_string(stream) + (stream == 0 ? "<" : ">") + name + "; " + command);
    ::fcntl(terminal, F_SETFL, O_NONBLOCK);
    char buffer[4096];
    for (ssize_t got = 0; (got = ::read(terminal, buffer, sizeof buffer)) > 0;)
        outcome.out.append(buffer, static_cast<std::size_t>(got));
    ::close(keep);
    ::close(terminal);
    return outcome;
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace soft::process
