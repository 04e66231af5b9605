// Probe of the probes: out[i] = (in[i] ^ mask) + offset. in[] repeats where it holds fewer than count words.
#version 460
layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kMask = 0u;
layout(push_constant) uniform Push {
    uint count;
    uint offset;
};
layout(std430, binding = 0) readonly buffer Input { uint inputs[]; };
layout(std430, binding = 1) buffer Output { uint outputs[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    outputs[i] = (inputs[i % inputs.length()] ^ kMask) + offset;
}
