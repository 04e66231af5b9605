#version 460
// Reads every field of shared/layout.h back, one word a field. Invocation i writes struct i of the list in main,
// record 1 of its array. src/verify/probes/layout.cpp lists the same fields.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 1u, kOutputWords = 32u;
#define VKPT_FRAME_BINDING 2
#include "probes/probe.glsl"
#include "geometry/fetch.glsl"
#include "geometry/load.glsl"

uint field = 0u;
void put(uint v) { putWord(field++, uvec4(v, 0u, 0u, 0u)); }
void put(float v) { put(floatBitsToUint(v)); }
void put(vec3 v) { putWord(field++, uvec4(floatBitsToUint(v), 0u)); }
void put(vec4 v) { putWord(field++, floatBitsToUint(v)); }

void putTriangle(TriangleRecord r) {
    put(r.v0); put(r.flags); put(r.v1); put(r.light); put(r.v2); put(r.primitive);
    put(r.i0); put(r.i1); put(r.i2); put(r.object);
}

void putVertex(VertexRecord r) { put(r.normal); put(r.u0); put(r.v0); put(r.tangent); }

void putVertexExtra(VertexExtra r) { put(r.u1); put(r.v1); put(r.colorRG); put(r.colorBA); }

void putNode(WideNode r) {
    put(r.origin); put(r.exponents); put(r.childBase); put(r.itemBase); put(r.meta0); put(r.meta1);
    put(r.loX0); put(r.loX1); put(r.loY0); put(r.loY1); put(r.loZ0); put(r.loZ1);
    put(r.hiX0); put(r.hiX1); put(r.hiY0); put(r.hiY1); put(r.hiZ0); put(r.hiZ1);
}

void putInstance(InstanceRecord r) {
    for (uint i = 0u; i < 3u; ++i) put(r.objectFromWorld[i]);
    for (uint i = 0u; i < 3u; ++i) put(r.worldFromObject[i]);
    put(r.rootNode); put(r.object);
}

void putMaterial(MaterialRecord r) {
    put(r.baseColor); put(r.emissive); put(r.metallic); put(r.roughness); put(r.normalScale); put(r.alphaCutoff);
    put(r.flags); put(r.baseColorTexture); put(r.metallicRoughnessTexture); put(r.normalTexture);
    put(r.emissiveTexture);
}

void putTexture(TextureRecord r) { put(r.texels); put(r.size); put(r.flags); put(r.stride); put(r.rowU); put(r.rowV); }

void putLight(LightRecord r) {
    put(r.a); put(r.kind); put(r.b); put(r.pmf); put(r.c); put(r.offset); put(r.color); put(r.index);
}

void putHeader(SceneHeader r) {
    put(r.nodes); put(r.triangles); put(r.vertices); put(r.vertexExtras); put(r.instances); put(r.materials);
    put(r.textures); put(r.texels); put(r.lights); put(r.lightCdf); put(r.lightCount); put(r.rootNode);
    put(r.envTexels); put(r.envRows); put(r.envColumns); put(r.envLight); put(r.envWidth); put(r.envHeight);
    put(r.envCos); put(r.envSin); put(r.samplerTable); put(r.bsdfs); put(r.albedoTables);
    put(r.filterTable); put(r.lightGroups); put(r.objectGroups); put(r.groupBehind);
}

void putParams(RenderParams r) {
    put(r.eye); put(r.projection); put(r.right); put(r.width); put(r.up); put(r.height); put(r.forward); put(r.seed);
    put(r.background); put(r.backgroundMode); put(r.spp); put(r.maxDepth); put(r.rrMode); put(r.rrDepth);
    put(r.rrFixed); put(r.lensRadius); put(r.focusDistance); put(r.clampIndirect); put(r.integrator); put(r.strategy);
    put(r.hemisphere); put(r.beta); put(r.bsdfSamples); put(r.lightSamples); put(r.aoDistance); put(r.pixelFilter);
    put(r.filterRadius);
}

void putBsdf(BsdfRecord r) {
    put(r.color); put(r.alphaX); put(r.diffuse); put(r.alphaY); put(r.eta); put(r.exponentX); put(r.k); put(r.exponentY);
    put(r.average); put(r.weight); put(r.flags); put(r.table); put(r.sigma); put(r.specular);
}

// A cell is read as a word, by albedoLookup and albedoMean.
void putCell(uvec4 w) { put(w.x); put(w.y); put(w.z); put(w.w); }

void putFilter(FilterCell r) { put(r.begin); put(r.end); put(r.weight); }

void main() {
    if (isIdle()) return;
    switch (inputWord(0u).x) {
        case 0u: putTriangle(loadTriangle(1u)); break;
        case 1u: putVertex(loadVertex(1u)); break;
        case 2u: putVertexExtra(loadVertexExtra(1u)); break;
        case 3u: putNode(loadNode(1u)); break;
        case 4u: putInstance(loadInstance(1u)); break;
        case 5u: putMaterial(loadMaterial(1u)); break;
        case 6u: putTexture(loadTexture(1u)); break;
        case 7u: putLight(loadLight(1u)); break;
        case 8u: putHeader(scene); break;
        case 9u: putParams(render); break;
        case 10u: putBsdf(loadBsdf(1u)); break;
        case 11u: putCell(sceneWord(scene.albedoTables + 1u)); break;
        case 12u: putFilter(loadFilterCell(1u)); break;
        case 13u: put(loadAbsorption(1u)); break;
    }
}
