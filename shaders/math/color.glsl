float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }
float maxComponent(vec3 v) { return max(v.x, max(v.y, v.z)); }
float maxMagnitude(vec3 v) { return maxComponent(abs(v)); }

// sRGB's transfer function, piecewise: display value to linear. [IEC 61966-2-1] Its power is x^2 (sqrt x)^0.8, the latter
// by a polynomial fitted to least relative error over the branch, exact at 1: within 1e-6 of every byte's value, where
// pow costs twice the time and is less exact.
vec3 srgbToLinear(vec3 c) {
    vec3 x = (c + 0.055) * (1.0 / 1.055), s = sqrt(x);
    vec3 p = s * 0.151206643 - 0.796005356;
    p = p * s + 1.82253714;
    p = p * s - 2.39893397;
    p = p * s + 2.04737253;
    p = p * s - 1.28749753;
    p = p * s + 1.43356695;
    p = p * s + 0.0277536013;
    return mix(x * x * p, c * (1.0 / 12.92), lessThanEqual(c, vec3(0.04045)));
}
