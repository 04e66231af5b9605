// out[i] = texel i of a uniform texel buffer XOR texel i of a storage texel buffer XOR in[i].
#version 460
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; };
layout(std430, binding = 0) readonly buffer Input { uvec4 inputs[]; };
layout(std430, binding = 1) writeonly buffer Output { uvec4 outputs[]; };
layout(binding = 2) uniform usamplerBuffer texels;
layout(binding = 3, rgba32ui) uniform readonly uimageBuffer images;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    outputs[i] = inputs[i] ^ texelFetch(texels, int(i)) ^ imageLoad(images, int(i));
}
