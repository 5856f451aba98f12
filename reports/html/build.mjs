// Bundles the browser part of the report and writes it as C++: node build.mjs OUTPUT.cpp
// String literals in pieces compile in a fraction of a second, where an array of bytes would take minutes.
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2];
if (!output) throw new Error("usage: node build.mjs OUTPUT.cpp");

async function bundled(entry) {
  const result = await build({
    entryPoints: [join(here, "assets", entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["chrome109", "firefox115", "safari16.4"],
    charset: "utf8",
    legalComments: "eof",
    loader: { ".woff2": "dataurl" },
    logLevel: "warning",
  });
  return result.outputFiles[0].text;
}

function literal(text) {
  const bytes = Buffer.from(text, "utf8");
  const lines = [];
  for (let at = 0; at < bytes.length; at += 4096) {
    let line = "";
    for (const byte of bytes.subarray(at, at + 4096)) {
      const c = String.fromCharCode(byte);
      if (c === "\\" || c === '"') line += "\\" + c;
      else if (c === "\n") line += "\\n";
      else if (byte < 32 || byte > 126 || c === "?") line += "\\" + byte.toString(8).padStart(3, "0");
      else line += c;
    }
    lines.push(`    "${line}"`);
  }
  return lines.join("\n");
}

const parts = {
  report_style: await bundled("style.css"),
  // The script stands inside <script>: nothing in it may end that element.
  report_script: (await bundled("main.js")).replaceAll("</script", "<\\/script"),
};
let source = '// Written by reports/html/build.mjs: do not edit.\n#include "reports/html/report_assets.h"\n\nnamespace icebow {\n';
for (const [name, text] of Object.entries(parts)) {
  const size = Buffer.byteLength(text, "utf8");
  source += `\nstd::string ${name}() {\n  static const char text[] =\n${literal(text)};\n  return {text, ${size}};\n}\n`;
  console.log(`${name}: ${(size / 1024).toFixed(0)} kB`);
}
const templates = readdirSync(join(here, "templates")).filter((file) => file.endsWith(".html")).sort();
source += "\nconst std::map<std::string, std::string>& report_templates() {\n  static const std::map<std::string, std::string> all = {\n";
for (const file of templates)
  source += `    {"${file.slice(0, -5)}",\n${literal(readFileSync(join(here, "templates", file), "utf8"))}},\n`;
source += "  };\n  return all;\n}\n";
writeFileSync(output, source + "\n}  // namespace icebow\n");
