/// Changes a file as another release or machine would write it, by plain HDF5 calls.
/// h5_change FILE older|version|unknown|big-endian DATASET
///   older        decreases the format version by one
///   version      increases the format version by one
///   unknown      adds groups, datasets and attributes that this release does not know
///   big-endian   converts the numbers of DATASET to big-endian byte order without changing their values
/// HDF5 removes the seal after the HDF5 data when it opens the file for writing.
#include <hdf5.h>

#include <cstdint>
#include <iostream>
#include <string_view>
#include <vector>

namespace {

void put_version(hid_t file, std::int64_t version) {
    const hid_t attribute = H5Aopen(file, "format_version", H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_INT64, &version);
    H5Aclose(attribute);
}

void add_unknown(hid_t file) {
    const double value = 1;
    const hid_t space = H5Screate(H5S_SCALAR),
                group = H5Gcreate2(file, "future", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t known = H5Gopen2(file, "shape", H5P_DEFAULT);
    for (const hid_t parent : {group, known}) {
        const hid_t dataset =
            H5Dcreate2(parent, "future_key", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value);
        H5Dclose(dataset);
    }
    const hid_t attribute = H5Acreate2(file, "future_attribute", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
    for (const auto close : {H5Aclose(attribute), H5Gclose(known), H5Gclose(group), H5Sclose(space)})
        static_cast<void>(close);
}

bool swap_bytes(hid_t file, const char* name) {
    const hid_t old = H5Dopen2(file, name, H5P_DEFAULT);
    if (old < 0) return false;
    const hid_t space = H5Dget_space(old);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    const hid_t layout = H5Dget_create_plist(old);
    H5Dread(old, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(old);
    H5Ldelete(file, name, H5P_DEFAULT);
    const hid_t swapped = H5Dcreate2(file, name, H5T_IEEE_F64BE, space, H5P_DEFAULT, layout, H5P_DEFAULT);
    const bool written = H5Dwrite(swapped, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0;
    H5Dclose(swapped);
    H5Pclose(layout);
    H5Sclose(space);
    return written;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view what = argc > 2 ? argv[2] : "";
    const hid_t file = argc > 2 ? H5Fopen(argv[1], H5F_ACC_RDWR, H5P_DEFAULT) : H5I_INVALID_HID;
    if (file < 0) return 1;
    bool done = true;
    if (what == "older")
        put_version(file, 1);
    else if (what == "version")
        put_version(file, 3);
    else if (what == "unknown")
        add_unknown(file);
    else
        done = what == "big-endian" && argc > 3 && swap_bytes(file, argv[3]);
    return H5Fclose(file) >= 0 && done ? 0 : 1;
}
