// webgpu.mjs CHROMIUM FOLDER : runs FOLDER/0.wgsl, 1.wgsl ... as compute shaders in headless Chromium's WebGPU, on the
// processor (SwiftShader): input N.in, output N.out of as many bytes as FOLDER/jobs says, line by line, "bytes groups".
// Prints one line, what ran them. Exit code 3: this Chromium offers no WebGPU here.
import { createServer } from "node:http";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { spawn } from "node:child_process";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [chromium, folder] = process.argv.slice(2);
const jobs = readFileSync(join(folder, "jobs"), "utf8").trim().split("\n").map(line => line.split(" ").map(Number));

async function inPage(jobs) {
    const post = (path, body) => fetch(path, { method: "POST", body });
    const get = async path => (await fetch(path)).arrayBuffer();
    try {
        const adapter = navigator.gpu && await navigator.gpu.requestAdapter();
        if (!adapter) { await post("/none", ""); return; }
        const device = await adapter.requestDevice();
        const storage = GPUBufferUsage.STORAGE;
        for (let n = 0; n < jobs.length; n++) {
            const [bytes, groups] = jobs[n];
            const code = new TextDecoder().decode(await get(`/${n}.wgsl`)), data = await get(`/${n}.in`);
            device.pushErrorScope("validation");
            const module = device.createShaderModule({ code });
            const pipeline = device.createComputePipeline({ layout: "auto", compute: { module, entryPoint: "main" } });
            const input = device.createBuffer({ size: data.byteLength, usage: storage | GPUBufferUsage.COPY_DST });
            const output = device.createBuffer({ size: bytes, usage: storage | GPUBufferUsage.COPY_SRC });
            const back = device.createBuffer({ size: bytes, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
            device.queue.writeBuffer(input, 0, data);
            const entries = [input, output].map((buffer, binding) => ({ binding, resource: { buffer } }));
            const group = device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries });
            const encoder = device.createCommandEncoder(), pass = encoder.beginComputePass();
            pass.setPipeline(pipeline);
            pass.setBindGroup(0, group);
            pass.dispatchWorkgroups(groups);
            pass.end();
            encoder.copyBufferToBuffer(output, 0, back, 0, bytes);
            device.queue.submit([encoder.finish()]);
            const error = await device.popErrorScope();
            if (error) { await post("/failed", `${n}.wgsl: ${error.message}`); return; }
            await back.mapAsync(GPUMapMode.READ);
            await post(`/${n}.out`, back.getMappedRange());
            for (const buffer of [input, output, back]) buffer.destroy();
        }
        const info = adapter.info || {};
        await post("/done", [info.vendor, info.architecture, info.description].filter(Boolean).join(" "));
    } catch (error) { await post("/failed", String(error)); }
}

const profile = mkdtempSync(join(tmpdir(), "prt-chromium-"));
let browser;
function finish(code, line) {
    if (line) (code ? console.error : console.log)(line);
    if (browser) { browser.removeAllListeners("exit"); browser.kill("SIGKILL"); }
    server.close();
    setTimeout(() => { rmSync(profile, { recursive: true, force: true, maxRetries: 10 }); process.exit(code); }, 200);
}
const server = createServer((request, response) => {
    const path = request.url;
    if (request.method === "GET") {
        if (path === "/") {
            response.setHeader("Content-Type", "text/html");
            response.end(`<script>(${inPage})(${JSON.stringify(jobs)})</script>`);
        } else if (/^\/\d+\.(wgsl|in)$/.test(path)) response.end(readFileSync(join(folder, path)));
        else { response.statusCode = 404; response.end(); }
        return;
    }
    const parts = [];
    request.on("data", part => parts.push(part));
    request.on("end", () => {
        const body = Buffer.concat(parts);
        response.end();
        if (/^\/\d+\.out$/.test(path)) writeFileSync(join(folder, path), body);
        else if (path === "/done") finish(0, `WebGPU: ${body}`);
        else if (path === "/none") finish(3, "no WebGPU adapter");
        else finish(1, body.toString());
    });
});
server.listen(0, "127.0.0.1", () => {
    browser = spawn(chromium, ["--headless=new", "--no-sandbox", "--disable-gpu-sandbox", "--no-first-run", "--enable-unsafe-webgpu",
        "--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan", `--user-data-dir=${profile}`,
        `http://127.0.0.1:${server.address().port}/`], { stdio: "ignore" });
    browser.on("error", () => finish(3, "Chromium does not start"));
    browser.on("exit", code => finish(3, `Chromium ended with ${code}`));
});
setTimeout(() => finish(1, "no answer from Chromium within 180 s"), 180000);
