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
#include "io/trial.hpp"

namespace soft::io {
namespace {

namespace fs = std::filesystem;

void write_whole(const fs::path& file, std::span<const std::byte> bytes) {
    core::AtomicFile whole{file};
    // A named pipe whose reader has left wants no more: nothing to report.
    static_cast<void>(whole.write(bytes));
    whole.commit();
}

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

/// One solve at a time writes to a file. The lock is on the open file, goes with its last descriptor, and leaves readers alone
/// (HDF5's own locks are of another kind); where the file system has no locks, nothing is locked.
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

Error taken(const std::string& name) {
    return {ExitCode::cannot_create, name, "another solve is writing it", "wait for its end, or name another file"};
}

/// Where there is no file yet, nobody writes it.
void require_no_writer(const fs::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    const bool free = is_free(descriptor, Lock::look);
    ::close(descriptor);
    if (!free) throw taken(file.string());
}

/// A file opened for appending, by one process.
class Tail {
public:
    explicit Tail(const fs::path& file) : Tail(file, ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)) {}
    Tail(const fs::path& file, int descriptor) : name_(file.string()), descriptor_(descriptor) {
        if (descriptor_ < 0)
            throw Error(ExitCode::cannot_create, name_,
                        "cannot be opened for writing: " + std::generic_category().message(errno));
        if (is_free(descriptor_, Lock::take)) return;
        ::close(descriptor_);
        throw taken(name_);
    }
    Tail(const Tail&) = delete;
    Tail& operator=(const Tail&) = delete;
    ~Tail() { ::close(descriptor_); }
    /// Cuts the file off, so that the next bytes follow the first `size`. It still must have the `known` bytes that were read.
    void cut(std::size_t size, std::size_t known) const {
        struct stat status {};
        if (::fstat(descriptor_, &status) != 0 || static_cast<std::size_t>(status.st_size) != known) throw taken(name_);
        if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0)
            throw Error(ExitCode::cannot_create, name_, "cannot be cut: " + std::generic_category().message(errno));
    }
    void append(std::span<const std::byte> bytes) const {
        static_cast<void>(core::write_all(descriptor_, bytes, name_));
    }
    /// Whether the name still leads to the file that was opened.
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
    /// The file as it is before the first step. It has no name until the first step is in it: a solve that is refused before
    /// leaves what stands under its name.
    void begin_journal() {
        require_no_writer(file);
        unnamed.emplace(file);
        static_cast<void>(unnamed->write(sealed_bytes(image)));
        // The same open file, locked before it has its name.
        journal.emplace(file, ::fcntl(unnamed->descriptor(), F_DUPFD_CLOEXEC, 0));
    }
    void append_record(RecordKind kind, std::span<const std::byte> payload) {
        const std::vector<std::byte> record = make_record(kind, payload);
        if (unnamed) {
            journal->append(record);
            require_no_writer(file);
            unnamed->commit();
            unnamed.reset();
            return;
        }
        try {
            journal->append(record);
        } catch (const Error& error) {
            throw Error(error.code(), "", error.what(), "make room and go on with solve --resume " + file.string());
        }
    }

    ResultImage image;
    fs::path file;                            ///< empty: in memory only
    std::optional<core::AtomicFile> unnamed;  ///< until the first step
    std::optional<Tail> journal;              ///< open until finish(), where the file can be appended to
    std::vector<std::byte> published;
    bool was_in_place = true;  ///< at every publish()
};

ResultWriter::ResultWriter(const Given& given, const Provenance& provenance, const ResultOptions& options) {
    const ImageParts parts = split_image(given.image, given.source);
    const QuietErrors quiet;
    const auto begun = [&] {
        return ResultImage::begin({parts.hdf5, given.source, given.solved}, provenance, options);
    };
    // What can be read need not bear being written to.
    if (!parts.sealed)
        try_apart({std::string{given.source}, parts.hdf5.size()}, [&](const Origin&) { static_cast<void>(begun()); });
    state_ = std::make_unique<State>(begun());
}

ResultWriter::ResultWriter(const fs::path& file, const Given& given, const Provenance& provenance,
                           const ResultOptions& options)
    : ResultWriter(given, provenance, options) {
    state_->file = file;
    if (!is_replaceable(file)) return;
    const QuietErrors quiet;
    state_->begin_journal();
}

ResultWriter::ResultWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}

ResultWriter ResultWriter::resume(const fs::path& file, const Given& given) {
    const QuietErrors quiet;
    const ImageParts parts = split_image(given.image, given.source);
    auto state = std::make_unique<State>(ResultImage::resume({parts.hdf5, given.source, given.solved}));
    state->file = file;
    state->journal.emplace(file);
    const std::size_t steps = parts.checkpoint ? parts.checkpoint->steps : 0;
    for (std::size_t i = 0; i < steps; ++i) {
        const JournalStep record = decode_step(parts.steps[i], given.source);
        state->image.append(record.step, record.displacement_m, record.pressure_Pa);
    }
    state->journal->cut(parts.checkpoint ? parts.checkpoint->end : seal_end(given.image, given.source),
                        given.image.size());
    return ResultWriter{std::move(state)};
}

ResultWriter::ResultWriter(ResultWriter&&) noexcept = default;
ResultWriter& ResultWriter::operator=(ResultWriter&&) noexcept = default;
ResultWriter::~ResultWriter() {
    const QuietErrors quiet;
    state_.reset();
}

void ResultWriter::append(const solution::Step& step, std::span<const double> displacement,
                          std::span<const double> pressure) {
    const QuietErrors quiet;
    state_->image.append(step, displacement, pressure);
    if (!state_->journal) return;
    const bool with_fields = state_->image.policy().keep != FieldsPolicy::Keep::none;
    const auto payload = with_fields ? encode_step(step, displacement, pressure) : encode_step(step, {}, {});
    state_->append_record(RecordKind::step, payload);
}

void ResultWriter::remember(const solution::Checkpoint& checkpoint) {
    if (state_->journal) state_->append_record(RecordKind::checkpoint, encode_checkpoint(checkpoint));
}

void ResultWriter::publish(ResultWriter rows, const solution::PathEnd& end) {
    state_->published = rows.finish(end);
    if (!state_->journal) return;
    state_->was_in_place = is_in_place();
    core::AtomicFile whole{state_->file};
    static_cast<void>(whole.write(state_->published));
    // Locked before it has its name, so that no other solve takes the file in between.
    state_->journal.emplace(state_->file, ::fcntl(whole.descriptor(), F_DUPFD_CLOEXEC, 0));
    whole.commit();
    state_->unnamed.reset();
}

bool ResultWriter::is_in_place() const {
    return !state_->journal || state_->unnamed || (state_->was_in_place && state_->journal->is_in_place());
}

std::vector<std::byte> ResultWriter::finish(const solution::PathEnd& end) {
    const QuietErrors quiet;
    std::vector<std::byte> bytes = std::move(state_->published);
    if (bytes.empty()) {
        state_->image.finish(end);
        bytes = sealed_bytes(state_->image);
    }
    if (!state_->file.empty()) write_whole(state_->file, bytes);
    state_->journal.reset();
    return bytes;
}

}  // namespace soft::io
