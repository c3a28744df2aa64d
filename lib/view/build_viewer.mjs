// Bundles viewer.js and its imports into one C++ file with the script and its licence.   node build_viewer.mjs OUTPUT.cpp
import { build } from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';

const bundle = await build({
  entryPoints: ['viewer.js'], bundle: true, minify: true, format: 'iife', target: 'es2020', charset: 'ascii', write: false,
  legalComments: 'none',
});
const script = bundle.outputFiles[0].text;
if (/<\/script|<!--/i.test(script)) throw new Error('the bundle would end its script element');

const three = JSON.parse(readFileSync('node_modules/three/package.json', 'utf8'));
const licence = readFileSync('node_modules/three/LICENSE', 'utf8');

// Raw strings in pieces: compilers need not support string literals longer than 64 KiB.
function literal(text) {
  const pieces = text.match(/[^]{1,32000}/g);
  return pieces.map((piece) => `    R"soft~(${piece})soft~"sv,`).join('\n');
}
writeFileSync(process.argv[2], `// Made by build_viewer.mjs.
#include "view/viewer_bundle.hpp"

namespace soft::view {
namespace {
using namespace std::string_view_literals;
constexpr std::string_view script[] = {
${literal(script)}
};
constexpr std::string_view licence[] = {
${literal(licence)}
};
}  // namespace

ViewerBundle viewer_bundle() noexcept { return {script, licence, "three.js ${three.version}", ""}; }

}  // namespace soft::view
`);
