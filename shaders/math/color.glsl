float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }
float maxComponent(vec3 v) { return max(v.x, max(v.y, v.z)); }

// sRGB's transfer function, exact and piecewise: display value to linear. [IEC 61966-2-1]
vec3 srgbToLinear(vec3 c) {
    return mix(pow((c + 0.055) * (1.0 / 1.055), vec3(2.4)), c * (1.0 / 12.92), lessThanEqual(c, vec3(0.04045)));
}
