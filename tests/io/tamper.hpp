#pragma once
/// Removes or replaces objects of a valid file.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/hdf5_write.hpp"

namespace soft::io::test {

inline void unlink(hid_t file, const char* name) { ASSERT_GE(H5Ldelete(file, name, H5P_DEFAULT), 0) << name; }

template <class T>
void replace(hid_t file, const std::string& group, const std::string& name, const std::vector<T>& values,
             std::vector<hsize_t> shape = {}) {
    const GroupHandle parent{H5Gopen2(file, group.c_str(), H5P_DEFAULT)};
    unlink(parent.get(), name.c_str());
    write_array<T>(parent.get(), {name, "1", "tampered"}, values, std::move(shape));
}

inline void replace_text(hid_t file, const std::string& group, const std::string& name, const std::string& text) {
    const GroupHandle parent{H5Gopen2(file, group.c_str(), H5P_DEFAULT)};
    unlink(parent.get(), name.c_str());
    write_text(parent.get(), {name, "1", "tampered"}, text);
}

inline void replace_texts(hid_t file, const std::string& group, const std::string& name,
                          const std::vector<std::string>& texts) {
    const GroupHandle parent{H5Gopen2(file, group.c_str(), H5P_DEFAULT)};
    unlink(parent.get(), name.c_str());
    write_texts(parent.get(), {name, "1", "tampered"}, texts);
}

}  // namespace soft::io::test
