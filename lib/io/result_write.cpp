#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/files.hpp"
#include "io/image.hpp"
#include "io/journal.hpp"
#include "io/result_file.hpp"
#include "io/result_image.hpp"
#include "io/subprocess_read.hpp"

namespace soft::io {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> sealed_bytes(const ResultImage& image) {
    std::vector<std::byte> bytes = image.bytes();
    seal(bytes);
    return bytes;
}

bool is_replaceable(const fs::path& file) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    return !fs::exists(status) || fs::is_regular_file(status);
}

/// Only one solve at a time writes to a file. The lock belongs to the open file description and is released with its last descriptor.
/// It does not affect readers (HDF5 uses a different kind of lock). File systems without locks are not protected.
enum class Lock { take, look };
bool is_free([[maybe_unused]] int descriptor, [[maybe_unused]] Lock lock) {
#ifdef F_OFD_SETLK
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    if (lock == Lock::take)
        return ::fcntl(descriptor, F_OFD_SETLK, &whole) == 0 || (errno != EAGAIN && errno != EACCES);
    return ::fcntl(descriptor, F_OFD_GETLK, &whole) != 0 || whole.l_type == F_UNLCK;
#else
    return true;
#endif
}

Error file_in_use(const std::string& name) {
    return {ExitCode::cannot_create, name, "another solve is writing to it",
            "wait until it ends or choose another file"};
}

/// Throws if another process writes the file. A file that does not exist has no writer.
void require_no_writer(const fs::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    const bool free = is_free(descriptor, Lock::look);
    ::close(descriptor);
    if (!free) throw file_in_use(file.string());
}

/// A file that is locked and opened for appending.
class Tail {
public:
    explicit Tail(const fs::path& file) : Tail(file, ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)) {}
    Tail(const fs::path& file, int descriptor) : name_(file.string()), descriptor_(descriptor) {
        if (descriptor_ < 0)
            throw Error(ExitCode::cannot_create, name_,
                        "cannot be opened for writing: " + std::generic_category().message(errno));
        if (is_free(descriptor_, Lock::take)) return;
        ::close(descriptor_);
        throw file_in_use(name_);
    }
    Tail(const Tail&) = delete;
    Tail& operator=(const Tail&) = delete;
    ~Tail() { ::close(descriptor_); }
    /// Truncates the file to `size` bytes. Throws if its size is no longer `known`, the number of bytes that were read.
    void truncate(std::size_t size, std::size_t known) const {
        struct stat status {};
        if (::fstat(descriptor_, &status) != 0 || static_cast<std::size_t>(status.st_size) != known)
            throw file_in_use(name_);
        if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0)
            throw Error(ExitCode::cannot_create, name_,
                        "cannot be truncated: " + std::generic_category().message(errno));
    }
    void append(std::span<const std::byte> bytes) const {
        static_cast<void>(core::write_all(descriptor_, bytes, name_));
    }
    /// True if the path still refers to the file that was opened.
    [[nodiscard]] bool is_in_place() const {
        struct stat open_file {
        }, named{};
        return ::fstat(descriptor_, &open_file) == 0 && ::stat(name_.c_str(), &named) == 0 &&
               open_file.st_dev == named.st_dev && open_file.st_ino == named.st_ino;
    }

private:
    std::string name_;
    int descriptor_;
};

}  // namespace

struct ResultWriter::State {
    explicit State(ResultImage begun) : image(std::move(begun)) {}
    /// Creates a file without a name and locks it, so that no other solve can lock it before commit() gives it its name.
    void create(std::span<const std::byte> bytes) {
        unnamed.emplace(file);
        static_cast<void>(unnamed->write(bytes));
        journal.emplace(file, ::fcntl(unnamed->descriptor(), F_DUPFD_CLOEXEC, 0));
    }
    void commit() {
        unnamed->commit();
        unnamed.reset();
    }
    void append_record(RecordKind kind, std::span<const std::byte> payload) {
        const std::vector<std::byte> record = make_record(kind, payload);
        try {
            journal->append(record);
        } catch (const Error& error) {
            if (unnamed) throw;
            throw Error(error.code(), "", error.what(),
                        "free disk space and continue with solve --resume " + file.string());
        }
        if (!unnamed) return;
        require_no_writer(file);
        commit();
    }

    ResultImage image;
    fs::path file;                            ///< empty: in memory only
    std::optional<core::AtomicFile> unnamed;  ///< until the first step
    std::optional<Tail> journal;              ///< open until finish(), if the file can be appended to
    std::vector<std::byte> published;
    bool was_in_place = true;  ///< is_in_place() was true at every publish()
};

ResultWriter::ResultWriter(const SolveInput& given, const Provenance& provenance, const ResultOptions& options) {
    const ImageParts parts = split_image(given.image, given.source);
    const QuietErrors quiet;
    const auto begun = [&] {
        return ResultImage::begin({parts.hdf5, given.source, given.solved}, provenance, options);
    };
    // A file without a seal that can be read may still crash HDF5 when it is written to.
    if (!parts.sealed)
        read_in_subprocess({std::string{given.source}, parts.hdf5.size()},
                           [&](const Origin&) { static_cast<void>(begun()); });
    state_ = std::make_unique<State>(begun());
}

ResultWriter::ResultWriter(const fs::path& file, const SolveInput& given, const Provenance& provenance,
                           const ResultOptions& options)
    : ResultWriter(given, provenance, options) {
    state_->file = file;
    if (!is_replaceable(file)) return;
    const QuietErrors quiet;
    require_no_writer(file);
    // An existing file stays unchanged until the first step, because the solve may fail before.
    state_->create(sealed_bytes(state_->image));
}

ResultWriter::ResultWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}

ResultWriter ResultWriter::resume(const fs::path& file, const SolveInput& given) {
    const QuietErrors quiet;
    const ImageParts parts = split_image(given.image, given.source);
    if (!parts.sealed)
        throw Error(ExitCode::bad_input, given.source, "the seal after the HDF5 data is missing", "run solve again");
    auto state = std::make_unique<State>(ResultImage::resume({parts.hdf5, given.source, given.solved}));
    state->file = file;
    if (parts.resume_steps == 0) {  // truncated, the file would have no row until the first step
        Tail{file}.truncate(given.image.size(), given.image.size());  // only checks
        state->create(sealed_bytes(state->image));
        return ResultWriter{std::move(state)};
    }
    state->journal.emplace(file);
    for (const auto payload : std::span{parts.steps}.first(parts.resume_steps)) {
        const JournalStep record = decode_step(payload, given.source);
        state->image.append(record.step, record.displacement_m, record.pressure_Pa);
    }
    state->journal->truncate(parts.resume_end, given.image.size());
    return ResultWriter{std::move(state)};
}

ResultWriter::ResultWriter(ResultWriter&&) noexcept = default;
ResultWriter& ResultWriter::operator=(ResultWriter&&) noexcept = default;
ResultWriter::~ResultWriter() {
    const QuietErrors quiet;
    state_.reset();
}

void ResultWriter::append(const model::Step& step, std::span<const double> displacement,
                          std::span<const double> pressure) {
    const QuietErrors quiet;
    state_->image.append(step, displacement, pressure);
    if (!state_->journal) return;
    if (state_->image.policy().keep == FieldsPolicy::Keep::none) displacement = pressure = {};
    state_->append_record(RecordKind::step, encode_step(step, displacement, pressure));
}

void ResultWriter::save_checkpoint(const model::Checkpoint& checkpoint) {
    if (state_->journal) state_->append_record(RecordKind::checkpoint, encode_checkpoint(checkpoint));
}

void ResultWriter::publish(ResultWriter rows, const model::PathEnd& end) {
    state_->published = rows.finish(end);
    if (!state_->journal) return;
    state_->was_in_place = is_in_place();
    state_->create(state_->published);
    state_->commit();
}

bool ResultWriter::is_in_place() const {
    return !state_->journal || state_->unnamed || (state_->was_in_place && state_->journal->is_in_place());
}

std::vector<std::byte> ResultWriter::finish(const model::PathEnd& end) {
    const QuietErrors quiet;
    std::vector<std::byte> bytes = std::move(state_->published);
    if (bytes.empty()) {
        state_->image.finish(end);
        bytes = sealed_bytes(state_->image);
    }
    if (!state_->file.empty()) {
        core::AtomicFile whole{state_->file};
        static_cast<void>(whole.write(bytes));  // a named pipe whose reader has closed it is not an error
        whole.commit();
    }
    state_->journal.reset();
    return bytes;
}

}  // namespace soft::io
