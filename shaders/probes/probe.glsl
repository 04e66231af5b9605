// What every probe kernel begins with: arrays in, arrays out, one invocation an input. The probe defines
// kInputWords and kOutputWords, the 16-byte words of one input and of one output, before it includes this.
#include "shared/constants.h"
#include "shared/dimensions.h"
#include "shared/layout.h"
#include "specialization.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; } push;
layout(std430, binding = 0) readonly buffer Inputs { uvec4 inputWords[]; };
layout(std430, binding = 1) writeonly buffer Outputs { uvec4 outputWords[]; };

// Words pass as integers, so that no bit of a float changes on the way.
uvec4 inputWord(uint k) { return inputWords[gl_GlobalInvocationID.x * kInputWords + k]; }
vec4 inputFloat(uint k) { return uintBitsToFloat(inputWord(k)); }
void putWord(uint k, uvec4 value) { outputWords[gl_GlobalInvocationID.x * kOutputWords + k] = value; }
void putFloat(uint k, vec4 value) { putWord(k, floatBitsToUint(value)); }
bool isIdle() { return gl_GlobalInvocationID.x >= push.count; }
