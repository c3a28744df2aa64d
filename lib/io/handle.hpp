#pragma once
/// RAII wrappers of HDF5 identifiers, and a scope that suppresses HDF5's error output. Internal to the module: no public header
/// includes this one.
#include <hdf5.h>

#include <utility>

namespace soft::io {

/// Owns one identifier and closes it with `close_id`. get() returns the raw identifier.
template <herr_t (*close_id)(hid_t)>
class Handle {
public:
    Handle() = default;
    explicit Handle(hid_t id) noexcept : id_(id) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            id_ = std::exchange(other.id_, H5I_INVALID_HID);
        }
        return *this;
    }
    ~Handle() { reset(); }

    [[nodiscard]] hid_t get() const noexcept { return id_; }
    explicit operator bool() const noexcept { return id_ >= 0; }
    void reset() noexcept {
        if (id_ >= 0) close_id(id_);
        id_ = H5I_INVALID_HID;
    }

private:
    hid_t id_ = H5I_INVALID_HID;
};

using FileHandle = Handle<H5Fclose>;
using GroupHandle = Handle<H5Gclose>;
using DatasetHandle = Handle<H5Dclose>;
using AttributeHandle = Handle<H5Aclose>;
using TypeHandle = Handle<H5Tclose>;
using SpaceHandle = Handle<H5Sclose>;
using PropertiesHandle = Handle<H5Pclose>;

/// Initialises HDF5; call before any other HDF5 function. Throws core::out_of_memory() if there is too little memory, because HDF5
/// crashes when it runs out of memory during initialisation.
void start_hdf5();

/// Suppresses HDF5's default printing of its error stack to stderr; this module reports failures as Errors. The previous handler is
/// restored at the end of the scope, so programs that use HDF5 themselves are not affected.
class QuietErrors {
public:
    QuietErrors() {
        start_hdf5();
        H5Eget_auto2(H5E_DEFAULT, &report_, &client_data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
    ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, report_, client_data_); }

private:
    H5E_auto2_t report_ = nullptr;
    void* client_data_ = nullptr;
};

}  // namespace soft::io
