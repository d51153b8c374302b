// wgsl_to_spirv.mjs MODULES A.wgsl B.wgsl ... : validates WGSL with naga and writes A.spv, B.spv ...; MODULES holds naga-wasm
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
const [modules, ...files] = process.argv.slice(2);
const { parseWgsl, validate, writeSpirv } = await import(pathToFileURL(`${modules}/naga-wasm/dist/node.js`).href);
for (const file of files) {
    try {
        const module = parseWgsl(readFileSync(file, "utf8"));
        const info = validate(module);
        const words = writeSpirv(module, info, {});
        writeFileSync(file.replace(/\.wgsl$/, ".spv"), Buffer.from(words.buffer, words.byteOffset, words.byteLength));
        info.free();
        module.free();
    } catch (error) {
        console.error(`${file}: ${error.message ?? error}`);
        process.exitCode = 1;
    }
}
