#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "registry.h"
#include "wavefront/renderer_impl.h"

namespace vkpt {
namespace {

using Clock = std::chrono::steady_clock;

bool useTexels(const Device& device, WavefrontConfig::Fetch fetch, std::size_t bytes) {
    const bool texelsFit = TexelView::fits(device, bytes);
    const bool storageFits = bytes <= device.info().limits.maxStorageBufferRange;
    if (!texelsFit && !storageFits)
        throw DeviceError(fmt::format("the scene needs {} MiB in one buffer; {} binds at most {} MiB", bytes >> 20,
                                      device.info().name,
                                      std::max<std::uint64_t>(device.info().limits.maxStorageBufferRange,
                                                              device.info().limits.maxTexelBufferElements * 16) >>
                                          20));
    if (fetch == WavefrontConfig::Fetch::Texel && !texelsFit)
        throw DeviceError("--fetch texel: the scene exceeds the device's maxTexelBufferElements; use storage");
    if (fetch == WavefrontConfig::Fetch::Storage && !storageFits)
        throw DeviceError("--fetch storage: the scene exceeds the device's maxStorageBufferRange; use texel");
    if (fetch != WavefrontConfig::Fetch::Auto) return fetch == WavefrontConfig::Fetch::Texel;
    return texelsFit && (device.info().isCpu || !storageFits);
}

/// Paths in flight unless the caller says: where kernels run on the CPU as many as its caches hold, else enough to fill
/// a large device.
std::uint32_t defaultPaths(const Device& device) { return device.info().isCpu ? 1U << 16U : 1U << 18U; }

/// Whether kernels take the forms that are quick where they run on the CPU: path state read through texels, which takes
/// a third of the time there, and lists of few triangles.
bool useCpuForms(const Device& device, WavefrontConfig::Fetch fetch) {
    return fetch != WavefrontConfig::Fetch::Storage && device.info().isCpu;
}

/// What kernels that know N fold: grids of strata, their reciprocals, lengths of loops.
std::uint32_t setSamples(const RenderOptions& options) {
    return samplerInfo(options.sampler.id).counts == SampleCounts::Any ? 0 : options.params.spp;
}

std::uint32_t lastIndex(const RenderOptions& options) { return std::max(options.params.spp, 1U) - 1; }

/// With the depth at which paths end. Throws Error (Usage) where that is more than the counters have room for.
RenderOptions withPathDepth(RenderOptions options) {
    constexpr std::uint32_t kMostDepth = kMaxBounceBlocks - 2;
    options.params.maxDepth = pathDepth(options.params);
    if (options.params.maxDepth > kMostDepth)
        throw Error(ExitCode::Usage, fmt::format("--max-depth {}: at most {}", options.params.maxDepth, kMostDepth));
    return options;
}

}  // namespace

WavefrontRenderer::Impl::Impl(const SceneArrays& arrays, const RenderOptions& renderOptions,
                              const WavefrontConfig& wavefrontConfig)
    : options(withPathDepth(renderOptions)),
      config(wavefrontConfig),
      device({config.device, config.validation}),
      layout(planScene(arrays, options.sampler, lastIndex(options), options.params)),
      filmLayout(options.aovs, options.light),
      capacity(config.pathsInFlight != 0 ? config.pathsInFlight : defaultPaths(device)),
      texels(useTexels(device, config.fetch, layout.bytes)),
      stateTexel(useCpuForms(device, config.fetch) && TexelView::fits(device, stateBytes(capacity))),
      ballot(config.ballot && device.info().subgroupBallot),
      features(arrays.features),
      kernelOptions(chooseKernels(arrays)),
      kernels(makeKernels(kernelOptions)),
      recorder(device, config.timings ? (kStageNames.size() - 3) * kBouncesPerSubmit + 5 : 0),
      pathsPerBatch(capacity) {
    const auto start = Clock::now();
    createBuffers(arrays);
    uploadSeconds = secondsSince(start);
}

/// Where few triangles are searched whole, shadow rays are traced where they begin: nearly every vertex has one, and
/// storing them costs as much as tracing them.
KernelOptions WavefrontRenderer::Impl::chooseKernels(const SceneArrays& arrays) const {
    const std::uint32_t integrator = options.params.integrator;
    KernelOptions o{.sampler = options.sampler,
                    .lastIndex = lastIndex(options),
                    .setSamples = setSamples(options),
                    .fetchTexel = texels,
                    .useBallot = ballot,
                    .stateTexel = stateTexel,
                    .film = filmLayout,
                    .params = options.params};
    if (!useCpuForms(device, config.fetch)) return o;
    o.listTriangles = listTriangles(arrays, integrator);
    o.stackEntries = stackEntries(arrays);
    o.inlineShadows = o.listTriangles > 0 && !needsNoBsdf(integrator);
    return o;
}

WavefrontKernels WavefrontRenderer::Impl::makeKernels(const KernelOptions& o) {
    return {device, config.kernels ? config.kernels : SpirvSource(kernelSpirv), features, layout.header, o};
}

void WavefrontRenderer::Impl::createBuffers(const SceneArrays& arrays) {
    const auto& limits = device.info().limits;
    const std::uint32_t width = options.params.width, height = options.params.height;
    const auto bandList = makeBands(width, height, limits.maxStorageBufferRange / filmBytesPerPixel());
    plan.add("scene", layout.bytes, !texels);
    plan.add("path state", stateBytes(capacity));
    plan.add("queues", counterBytes(capacity));
    for (const Band& band : bandList) plan.add("film", band.pixelCount * filmBytesPerPixel());
    plan.check(device.info());

    frame = Buffer(device, BufferUse::Uniform, sizeof(Frame), "frame");
    scene = Buffer(device, BufferUse::Storage, layout.bytes, "scene");
    dummy = Buffer(device, BufferUse::Storage, 16, "dummy");
    state = Buffer(device, BufferUse::Storage, stateBytes(capacity), "path state");
    counters = Buffer(device, BufferUse::Indirect, counterBytes(capacity), "queues");
    freshCounters = Buffer(device, BufferUse::Upload, usedCounterBytes(), "fresh counters");
    readback = Buffer(device, BufferUse::Readback, usedCounterBytes(), "counters read back");
    sceneTexels = texels ? TexelView(device, scene, VK_FORMAT_R32G32B32A32_UINT, 0, layout.bytes)
                         : TexelView(device, dummy, VK_FORMAT_R32G32B32A32_UINT, 0, 16);
    stateTexels = stateTexel ? TexelView(device, state, VK_FORMAT_R32G32B32A32_UINT, 0, stateBytes(capacity))
                             : TexelView(device, dummy, VK_FORMAT_R32G32B32A32_UINT, 0, 16);

    writeFrame();
    const std::vector<QueueCounter> fresh(usedCounterBytes() / sizeof(QueueCounter));
    std::memcpy(freshCounters.map().data(), fresh.data(), usedCounterBytes());
    uploadScene(device, scene, arrays, layout);
    for (const Band& band : bandList) {
        FilmBand b{band, Buffer(device, BufferUse::Storage, band.pixelCount * filmBytesPerPixel(), "film"), {}};
        const std::array<Binding, 7> bindings = {
            frame, texels ? dummy : scene, sceneTexels, state, counters, b.film, stateTexels};
        b.group = BindGroup(device, kernels.generate, bindings);
        bands.push_back(std::move(b));
    }
}

void WavefrontRenderer::Impl::writeFrame() {
    const Frame contents = makeFrame(layout, options.params);
    std::memcpy(frame.map().data(), &contents, sizeof contents);
}

}  // namespace vkpt
