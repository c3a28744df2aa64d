#include "io/provenance.hpp"

#include "core/text.hpp"
#include "io/case_check.hpp"
#include "io/hdf5_write.hpp"
#include "io/provenance_io.hpp"

namespace soft::io {

void write_provenance(hid_t provenance_group, const Provenance& provenance) {
    if (!is_name(provenance.tool))
        throw Error(ExitCode::internal, "/provenance",
                    core::quoted(provenance.tool) + " is not a valid name of a tool");
    const GroupHandle record = create_group(provenance_group, provenance.tool, "how this program was run");
    write_text(record.get(), {"tool", "1", "name of the program"}, provenance.tool);
    write_text(record.get(), {"version", "1", "release of the program"}, provenance.version);
    write_text(record.get(), {"revision", "1", "git revision of its source"}, provenance.revision);
    write_texts(record.get(), {"libraries", "1", "name and version of each library"}, provenance.libraries);
    write_text(record.get(), {"command_line", "1", "as typed"}, provenance.command_line);
}

std::vector<Provenance> read_provenance(const GroupReader& root) {
    std::vector<Provenance> records;
    const GroupReader group = root.group("provenance");
    for (const std::string& tool : group.names()) {
        const GroupReader record = group.group(tool);
        if (record.text("tool") != tool) throw record.refuse("tool", "does not match the name of its record");
        records.push_back({tool, record.text("version"), record.text("revision"), record.texts("libraries"),
                           record.text("command_line")});
    }
    return records;
}

}  // namespace soft::io
