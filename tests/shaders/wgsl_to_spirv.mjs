// wgsl_to_spirv.mjs MODULES IN.wgsl OUT.spv ... : validates WGSL with naga and writes SPIR-V; MODULES holds naga-wasm
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
const [modules, ...files] = process.argv.slice(2);
const { parseWgsl, validate, writeSpirv } = await import(pathToFileURL(`${modules}/naga-wasm/dist/node.js`).href);
for (let i = 0; i + 1 < files.length; i += 2) {
    try {
        const module = parseWgsl(readFileSync(files[i], "utf8"));
        const info = validate(module);
        const words = writeSpirv(module, info, {});
        writeFileSync(files[i + 1], Buffer.from(words.buffer, words.byteOffset, words.byteLength));
        info.free();
        module.free();
    } catch (error) {
        console.error(`${files[i]}: ${error.message ?? error}`);
        process.exitCode = 1;
    }
}
