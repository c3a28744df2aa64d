# Checks the dependencies between modules.  awk -f check.awk dependencies.txt FILE...   with FILEs named lib/<module>/...
# (headers, sources and the modules' CMakeLists.txt). Prints "file:line: problem; remedy" for each violation.
# Exit code 1 if there are violations, 2 if no files were given.

function violation(location, text) { print location ": " text; violations++ }
function module_of(path,  part) { split(path, part, "/"); return part[2] }

# ---- the table
FILENAME == ARGV[1] {
    sub(/#.*/, "")
    if ($0 !~ /:/) next
    kind = $1; name = $2; sub(/:$/, "", name)
    if (kind == "module") known[name] = 1; else headers[++header_count] = name
    for (i = 3; i <= NF; i++) allowed[kind, name, $i] = 1
    next
}

FNR == 1 {
    file = FILENAME; module = module_of(file); in_list = 0; uses = 0; files++
    if (!(module in known)) violation(file, "module " module " is not in tests/layers/dependencies.txt; add it there")
}

# ---- USES lists of the modules' CMakeLists.txt
file ~ /CMakeLists\.txt$/ {
    sub(/#.*/, "")
    if ($0 ~ /soft_module[ \t]*\(/) in_list = 1
    if (in_list) {
        text = $0; ends = text ~ /\)/; gsub(/[()]/, " ", text)
        count = split(text, word, " ")
        for (i = 1; i <= count; i++) {
            if (word[i] ~ /^(SOURCES|USES|LIBRARIES)$/) { uses = word[i] == "USES"; continue }
            if (!uses) continue
            declared[module, word[i]] = 1
            if (!((("module" SUBSEP module) SUBSEP word[i]) in allowed))
                violation(file ":" FNR, "USES " word[i] " is not an allowed dependency of module " module "; see tests/layers/dependencies.txt")
        }
        if (ends) in_list = uses = 0
    }
    next
}

# ---- #include lines
/^[ \t]*#[ \t]*include[ \t]*["<]/ {
    quoted = $0 ~ /include[ \t]*"/
    header = $0; sub(/^[^"<]*["<]/, "", header); sub(/[">].*/, "", header)
    location = file ":" FNR
    target = header; sub(/\/.*/, "", target)
    if (header ~ /\// && target in known) {
        includes++
        edge_count++; from[edge_count] = file; to[edge_count] = "lib/" header; at[edge_count] = location
        if (target != module) {
            if (!(("module", module, target) in allowed))
                violation(location, "module " module " may not include " header "; see tests/layers/dependencies.txt")
            if (!((module, target) in included)) included[module, target] = location
        }
    } else if (header ~ /(^|\/)(\.\.|tools)\//) {
        violation(location, header " is outside lib/; include only files of lib, with paths that start at a module")
    } else if (quoted) {
        violation(location, "\"" header "\" does not start with a module; write \"module/file.hpp\"")
    }
    for (i = 1; i <= header_count; i++)
        if (index(header, headers[i]) == 1) {
            reached[file, headers[i]] = 1
            if (!(("header", headers[i], module) in allowed))
                violation(location, "module " module " may not include <" header ">; see tests/layers/dependencies.txt")
        }
}

END {
    if (files == 0) { print "no files were given"; exit 2 }
    # Propagate the restricted headers that each file reaches through its includes until nothing changes.
    do {
        changed = 0
        for (e = 1; e <= edge_count; e++)
            for (i = 1; i <= header_count; i++)
                if ((to[e], headers[i]) in reached && !((from[e], headers[i]) in reached)) {
                    reached[from[e], headers[i]] = 1; changed = 1
                    if (!(("header", headers[i], module_of(from[e])) in allowed))
                        violation(at[e], "reaches <" headers[i] "...> through " to[e] "; keep it out of that header")
                }
    } while (changed)
    for (pair in included) {
        split(pair, p, SUBSEP)
        if (("module", p[1], p[2]) in allowed && !(pair in declared))
            violation(included[pair], "includes module " p[2] ", which lib/" p[1] "/CMakeLists.txt does not name; add it to USES")
    }
    printf "%d files, %d includes between files of lib, %d violations\n", files, includes, violations
    exit violations > 0
}
