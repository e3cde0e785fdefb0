// Shaders of the view in space. All geometry stands still; one texture of poses moves it.

const COMMON = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DShadow;
vec3 encode(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
`;

/** A pose lies in two texels: quaternion, then centre. A panel's corners lie in four, which have its
 * neighbours beside the coordinates, -1 where there is none. */
const POSES = /* glsl */ `
uniform sampler2D poses, corners;
vec4 turnOf(int panel) { return texelFetch(poses, ivec2(2 * (panel & 511), panel >> 9), 0); }
vec3 centreOf(int panel) { return texelFetch(poses, ivec2(2 * (panel & 511) + 1, panel >> 9), 0).xyz; }
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
vec3 normalOf(int panel) { return turned(turnOf(panel), vec3(0.0, 0.0, 1.0)); }
vec4 cornerOf(int corner) { return texelFetch(corners, ivec2(corner & 2047, corner >> 11), 0); }
vec3 carried(vec3 point, int panel) { return turned(turnOf(panel), point) + centreOf(panel); }
/** Place of a corner by its number: four times its panel's, and which of the four. */
vec3 placed(int corner) { return carried(cornerOf(corner).xyz, corner >> 2); }
`;

/** Share of the key light that reaches a point: mean of comparisons on a disc. */
const SHADOW = /* glsl */ `
uniform sampler2DShadow shadowMap;
uniform mat4 shadowMatrix;
uniform float shadowTexel;
uniform int shadowTaps;
float lit(vec3 place, float bias, float spread) {
  if (shadowTaps == 0) return 1.0;
  vec3 at = (shadowMatrix * vec4(place, 1.0)).xyz;
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
  float sum = 0.0;
  for (int i = 0; i < shadowTaps; i++) {
    float r = sqrt((float(i) + 0.5) / float(shadowTaps)), a = 2.399963 * float(i);
    vec2 offset = r * vec2(cos(a), sin(a)) * spread * shadowTexel;
    sum += texture(shadowMap, vec3(at.xy + offset, at.z - bias));
  }
  return sum / float(shadowTaps);
}
`;

/** Panels and boards. `corner`: which one is near, four times the panel's number and which of the
 * four; `point`: place of the vertex in its panel's frame; `rim`: 0 along edges to be drawn, 1 far
 * from them. */
const solidVertex = (inputs: string, corner: string, point: string, rim: string): string => /* glsl */ `${COMMON}${POSES}
${inputs}
in float amount;
uniform mat4 viewMatrix, projectionMatrix;
uniform int colouring;
out vec3 place, normal;
out float value, over, inside;
flat out int panel;
float angleTo(float other) {
  return other < 0.0 ? 0.0 : acos(clamp(dot(normal, normalOf(int(other))), -1.0, 1.0));
}
void main() {
  int near = ${corner};
  vec3 local = ${point};
  panel = near >> 2;
  normal = normalOf(panel);
  place = carried(local, panel);
  over = local.z;
  inside = ${rim};
  value = 0.0;
  if (colouring == 2) {
    for (int k = 0; k < 4; k++) value = max(value, angleTo(cornerOf(4 * panel + k).w) / 3.14159265);
  } else if (colouring == 3) {
    value = amount;
  }
  gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
}`;

export const panelVertex = solidVertex("", "gl_VertexID", "cornerOf(near).xyz", "1.0");
export const boardVertex = solidVertex("in vec3 point; in float corner, rim;", "int(corner)", "point", "rim");

/** `upper`: whether it is of the sheet's upper face; `outward`: the normal towards the eye;
 * `tone`: how much of its colour it keeps; `ink`: draws its edges. */
const solidFragment = (upper: string, outward: string, tone: string, ink = ""): string => /* glsl */ `${COMMON}${SHADOW}
in vec3 place, normal;
in float value, over, inside;
flat in int panel;
uniform vec3 cameraPosition, light, front, back, sky, earth, hoverColour, contactColour, palette[5];
uniform int colouring, hovered;
uniform ivec2 touching;
uniform sampler2D map;
uniform float range, shadowBias, covered, density;
out vec4 colour;
void main() {
  vec3 across = normalize(normal), eye = normalize(cameraPosition - place);
  vec3 n = ${outward};
  bool top = ${upper};
  vec3 base = top ? front : back;
  if (colouring >= 2) {
    float at = colouring == 2 ? value : 0.5 + 0.5 * value / range;
    vec3 mapped = pow(texture(map, vec2(clamp(at, 0.002, 0.998), 0.5)).rgb, vec3(2.2));
    bool known = value < 1e20;
    base = known ? mapped * (top ? 1.0 : 0.86) : base * 0.8;
  }
  base *= ${tone};
  bool touches = panel == touching.x || panel == touching.y;
  if (touches) base = mix(base, contactColour, 0.9);
  if (panel == hovered) base = mix(base, hoverColour, touches ? 0.4 : 0.6);
  float facing = dot(n, light);
  // A surface that turns its other side to the light is in its own shadow.
  float key = facing > 0.0 ? facing * lit(place + n * shadowBias, 0.0006, 2.2) : 0.0;
  vec3 ambient = mix(earth, sky, 0.5 + 0.5 * n.z);
  vec3 lighting = 0.5 * ambient + 0.54 * key + 0.08 * max(dot(n, eye), 0.0);
  ${ink}
  colour = vec4(encode(base * lighting), 1.0);
}`;

/** Between boards a panel is their hinge, and darker. */
export const panelFragment = solidFragment("gl_FrontFacing", "gl_FrontFacing ? across : -across", "mix(1.0, 0.45, covered)");
/** Sides of a board are darker than its faces, whose edges are lines on the screen. */
export const boardFragment = solidFragment(
  "over > 0.0", "normalize(cross(dFdx(place), dFdy(place)))", "(abs(dot(n, across)) > 0.995 ? 1.0 : 0.72)",
  /* glsl */ `float step = fwidth(inside);
  float line = (1.0 - smoothstep(0.5 * density, 1.3 * density, inside / max(step, 1e-6))) * (1.0 - smoothstep(0.1, 0.5, step));
  base = mix(base, palette[3], 0.8 * line);`,
);

export const depthVertex = /* glsl */ `${COMMON}${POSES}
uniform mat4 viewMatrix, projectionMatrix;
void main() { gl_Position = projectionMatrix * viewMatrix * vec4(placed(gl_VertexID), 1.0); }`;

export const depthFragment = /* glsl */ `precision lowp float; out vec4 colour; void main() { colour = vec4(1.0); }`;

/** Lines as wide as asked on the screen, with soft edges; those of tiny panels are finer, then paler. */
const WIDE = /* glsl */ `
uniform mat4 viewMatrix, projectionMatrix;
uniform vec2 screen;
uniform float density, near;
out float across, reach, strength;
void widen(vec3 from, vec3 to, float width, float share) {
  vec2 way = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  vec4 u = viewMatrix * vec4(from, 1.0), v = viewMatrix * vec4(to, 1.0);
  if (u.z > -near && v.z > -near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); across = reach = strength = 0.0; return; }
  if (u.z > -near) u = mix(u, v, (-near - u.z) / (v.z - u.z));
  if (v.z > -near) v = mix(v, u, (-near - v.z) / (u.z - v.z));
  vec4 p = projectionMatrix * u, q = projectionMatrix * v;
  vec2 step = (q.xy / q.w - p.xy / p.w) * 0.5 * screen;
  float size = length(step);
  vec2 along = size > 1e-4 ? step / size : vec2(1.0, 0.0);
  float wanted = min(width * density, max(share * size, 0.3));
  reach = 0.5 * max(wanted, 1.0);
  strength = min(wanted, 1.0);
  across = way.y * (reach + 1.0);
  vec2 offset = way.x * along * reach + across * vec2(-along.y, along.x);
  gl_Position = way.x < 0.0 ? p : q;
  gl_Position.xy += offset / (0.5 * screen) * gl_Position.w;
}
`;

export const creaseVertex = /* glsl */ `${COMMON}${POSES}${WIDE}
in vec4 ends; // corners: begin and end in the one panel, begin and end in the other
in float letter;
uniform int hovered;
uniform ivec2 touching;
uniform vec3 palette[5];
uniform float widths[5];
uniform vec3 hoverColour, contactColour;
out vec3 tint;
bool beside(int panel) { return panel >= 0 && (int(ends.x) >> 2 == panel || int(ends.z) >> 2 == panel); }
void main() {
  float width = widths[int(letter)];
  tint = palette[int(letter)];
  bool marked = beside(touching.x) || beside(touching.y), chosen = beside(hovered);
  if (marked) { width = 3.2; tint = contactColour; }
  if (chosen) { width = 2.6; tint = hoverColour; }
  // Between two states the panels beside a crease part by a hair: it is drawn in the middle.
  vec3 from = 0.5 * (placed(int(ends.x)) + placed(int(ends.z)));
  vec3 to = 0.5 * (placed(int(ends.y)) + placed(int(ends.w)));
  widen(from, to, width, marked || chosen ? 0.5 : 0.11);
}`;

/** Lines of one pixel, for sheets whose panels are so small that finer lines were drawn anyway. */
export const threadVertex = /* glsl */ `${COMMON}${POSES}
in vec4 ends;
in float letter;
uniform mat4 viewMatrix, projectionMatrix;
uniform vec3 palette[5];
uniform float widths[5];
uniform float thread;
out vec3 tint;
out float across, reach, strength;
void main() {
  bool begin = (gl_VertexID & 1) == 0;
  vec3 place = 0.5 * (placed(int(begin ? ends.x : ends.y)) + placed(int(begin ? ends.z : ends.w)));
  gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
  tint = palette[int(letter)];
  across = 0.0;
  reach = 1.0;
  strength = min(1.0, thread * widths[int(letter)]);
}`;

export const curveVertex = /* glsl */ `${COMMON}${WIDE}
in vec3 from, to;
uniform vec3 ink;
uniform float width;
out vec3 tint;
void main() { tint = ink; widen(from, to, width, 1e6); }`;

/** What a load case displaces is drawn `times` as far. */
const MOVED = /* glsl */ `
uniform float times;
`;

export const loadedVertex = /* glsl */ `${COMMON}${MOVED}
in vec3 position, moved;
in float amount;
uniform mat4 viewMatrix, projectionMatrix;
out vec3 place;
out float value;
void main() {
  place = position + times * moved;
  value = amount;
  gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
}`;

export const loadedFragment = /* glsl */ `${COMMON}
in vec3 place;
in float value;
uniform vec3 cameraPosition, light, front, sky, earth;
uniform sampler2D amounts;
out vec4 colour;
void main() {
  vec3 n = normalize(cross(dFdx(place), dFdy(place))), eye = normalize(cameraPosition - place);
  vec3 mapped = pow(texture(amounts, vec2(clamp(value, 0.002, 0.998), 0.5)).rgb, vec3(2.2));
  vec3 base = value < 1e20 ? mapped : front * 0.8;
  vec3 ambient = mix(earth, sky, 0.5 + 0.5 * n.z);
  colour = vec4(encode(base * (0.55 * ambient + 0.35 * max(dot(n, light), 0.0) + 0.15 * max(dot(n, eye), 0.0))), 1.0);
}`;

export const loadedLineVertex = /* glsl */ `${COMMON}${WIDE}${MOVED}
in vec3 from, to, fromMoved, toMoved;
uniform vec3 ink;
uniform float width;
out vec3 tint;
void main() { tint = ink; widen(from + times * fromMoved, to + times * toMoved, width, 0.5); }`;

export const lineFragment = /* glsl */ `${COMMON}
in vec3 tint;
in float across, reach, strength;
uniform float opacity;
out vec4 colour;
void main() { colour = vec4(encode(tint), strength * opacity * clamp(reach + 0.5 - abs(across), 0.0, 1.0)); }`;

export const groundVertex = /* glsl */ `${COMMON}
in vec3 position;
uniform mat4 viewMatrix, projectionMatrix;
uniform vec3 middle;
uniform float reach;
out vec3 place;
void main() {
  place = middle + vec3(position.xy * reach, 0.0);
  gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
}`;

export const groundFragment = /* glsl */ `${COMMON}${SHADOW}
in vec3 place;
uniform vec3 middle, gridColour, shadowColour;
uniform vec2 gridOrigin;
uniform float reach, cell, shadowStrength, density;
out vec4 colour;
float lines(vec2 at, float width) {
  vec2 slope = fwidth(at);
  vec2 distance = abs(fract(at - 0.5) - 0.5) / slope;
  vec2 line = (1.0 - smoothstep(width * 0.5 - 0.5, width * 0.5 + 0.5, distance)) * (1.0 - smoothstep(0.12, 0.45, slope));
  return max(line.x, line.y);
}
void main() {
  float away = length(place.xy - middle.xy) / reach;
  float fade = 1.0 - smoothstep(0.25, 0.95, away);
  vec2 at = (place.xy - gridOrigin) / cell;
  float grid = max(0.13 * lines(at, density), 0.3 * lines(at / 5.0, 1.2 * density)) * fade;
  float dark = shadowStrength * (1.0 - lit(place, 0.0, 9.0)) * fade;
  float alpha = 1.0 - (1.0 - grid) * (1.0 - dark);
  colour = vec4(mix(gridColour, shadowColour, alpha > 0.0 ? dark / max(grid + dark, 1e-4) : 0.0), alpha);
}`;

export const surfaceVertex = /* glsl */ `${COMMON}
in vec3 position, normal;
in vec2 uv;
uniform mat4 viewMatrix, projectionMatrix;
out vec3 place, facing;
out vec2 at;
void main() {
  place = position; facing = normal; at = uv;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`;

export const surfaceFragment = /* glsl */ `${COMMON}
in vec3 place, facing;
in vec2 at;
uniform vec3 cameraPosition, ink;
uniform vec2 cells;
uniform float density;
out vec4 colour;
void main() {
  vec3 n = normalize(facing), eye = normalize(cameraPosition - place);
  float rim = 1.0 - abs(dot(n, eye));
  vec2 u = at * cells, slope = fwidth(u);
  vec2 line = 1.0 - smoothstep(0.0, density, abs(fract(u - 0.5) - 0.5) / slope);
  float alpha = 0.2 + 0.3 * rim * rim + 0.22 * max(line.x, line.y);
  colour = vec4(encode(ink * (0.75 + 0.35 * abs(n.z))), alpha);
}`;

/** Round dots, as large on the screen as asked, a little nearer than what they stand on. */
export const dotVertex = /* glsl */ `${COMMON}
in vec3 position;
uniform mat4 viewMatrix, projectionMatrix;
uniform float width, density;
void main() {
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
  gl_Position.z -= 2e-4 * gl_Position.w;
  gl_PointSize = width * density;
}`;

export const dotFragment = /* glsl */ `${COMMON}
uniform vec3 ink;
uniform float width, density, opacity;
out vec4 colour;
void main() {
  float away = length(gl_PointCoord - 0.5) * width * density;
  colour = vec4(encode(ink), opacity * clamp(0.5 * width * density - away, 0.0, 1.0));
}`;

/** A flat figure that stands upright and turns about itself towards the eye. */
export const figureVertex = /* glsl */ `${COMMON}
in vec3 position;
uniform mat4 viewMatrix, projectionMatrix;
uniform vec3 foot, cameraPosition;
uniform float tall;
void main() {
  vec2 away = normalize(cameraPosition.xy - foot.xy);
  vec3 place = foot + tall * (position.x * vec3(-away.y, away.x, 0.0) + vec3(0.0, 0.0, position.y));
  gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
}`;

/** One colour, a little lighter where it is seen through. */
export const plainFragment = /* glsl */ `${COMMON}
uniform vec3 ink;
uniform float opacity;
out vec4 colour;
void main() { colour = vec4(encode(ink), opacity); }`;

/** Another shell, as glass. */
export const ghostVertex = /* glsl */ `${COMMON}
in vec3 position;
uniform mat4 viewMatrix, projectionMatrix;
out vec3 place;
void main() {
  place = position;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`;

export const ghostFragment = /* glsl */ `${COMMON}
in vec3 place;
uniform vec3 cameraPosition, ink;
out vec4 colour;
void main() {
  vec3 n = normalize(cross(dFdx(place), dFdy(place))), eye = normalize(cameraPosition - place);
  colour = vec4(encode(ink * (0.7 + 0.4 * abs(n.z))), 0.16 + 0.2 * (1.0 - abs(dot(n, eye))));
}`;
