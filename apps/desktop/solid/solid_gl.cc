#include "desktop/solid/solid_gl.h"

#include <QByteArray>
#include <QMatrix4x4>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "felt/solid/creases.h"

namespace felt::desktop {
namespace {

/// One point of a body in graphics memory.
struct GlPoint {
  std::array<float, 3> at;             // mm
  std::array<std::int16_t, 4> normal;  // -32767..32767 for -1..1; the last one is unused
  std::array<std::uint8_t, 4> color;
};
static_assert(sizeof(GlPoint) == 24);

constexpr int kSamplesPerPixel = 8;  // or as many as OpenGL has
/// Software OpenGL paints about 10^5 lines in the time of a frame at 20 frames a second
/// (solid_scene_bench.cc), and so many lines cannot be told apart anyway.
constexpr GLsizei kMaxFastLines = 30'000;

/// The shaders are also valid for OpenGL ES 2.0, which has no CENTROID. Without that, a smooth
/// picture has specks beside a section, where the middle of a pixel is outside of a triangle. The
/// formula of the light is that of paint_solid().
constexpr const char* kVertexShader = R"(
attribute vec3 at;
attribute vec3 normal;
attribute vec3 color;
uniform mat4 to_clip;
varying vec3 point_normal;
varying vec3 point_color;
CENTROID varying vec3 at_mm;
void main() {
  gl_Position = to_clip * vec4(at, 1.0);
  point_normal = normal;
  point_color = color;
  at_mm = at;
}
)";

constexpr const char* kFragmentShader = R"(
#ifdef GL_ES
precision highp float;
#endif
uniform vec3 to_lamp;
uniform vec3 half_way;
uniform vec3 up;
uniform vec3 towards;
varying vec3 point_normal;
varying vec3 point_color;
CENTROID varying vec3 at_mm;
uniform sampler2D ink;
uniform vec4 ink_place;  // the share of the picture at the origin, and for each mm
uniform bool has_ink;
#ifdef SECTION
uniform vec3 cut_color;
uniform float section_mm;
#endif
void main() {
#ifdef SECTION
  if (at_mm.x > section_mm) discard;
  if (!gl_FrontFacing) {
    gl_FragColor = vec4(mix(point_color, cut_color, 0.6), 1.0);
    return;
  }
#endif
  vec3 n = normalize(point_normal);
  float shade = 1.0;
#ifdef LINES
  if (dot(n, towards) < 0.0) discard;
  shade = 0.45;
#endif
  vec3 coat = point_color;
  if (has_ink && at_mm.z > 0.0 && n.z > 0.001) {
    vec4 on_it = texture2D(ink, ink_place.xy + at_mm.xy * ink_place.zw);
    coat = on_it.rgb + (1.0 - on_it.a) * coat;
  }
  float direct = max(0.0, dot(n, to_lamp));
  float sky = 0.5 + 0.5 * dot(n, up);
  float s = max(0.0, dot(n, half_way));
  float s2 = s * s, s4 = s2 * s2, s8 = s4 * s4, s16 = s8 * s8;
  float shine = s16 * s16 * s8;  // the 40th power: faster than pow() in software
  gl_FragColor = vec4(shade * (coat * (0.42 + 0.16 * sky + 0.50 * direct) + 0.12 * shine), 1.0);
}
)";

/// Returns the matrix from mm to clip space. The picture is upside down, because OpenGL reads
/// pixels from the bottom.
QMatrix4x4 to_clip(const SolidCamera& camera, QSize size, double radius_mm) {
  const double sx = 2.0 / size.width(), sy = 2.0 / size.height();
  const Vec3 x = sx * camera.px_per_mm * camera.right, y = -sy * camera.px_per_mm * camera.up,
             z = (-1.0 / std::max(radius_mm, 1e-9)) * camera.towards;
  const auto f = [](double v) { return static_cast<float>(v); };
  return {f(x.x), f(x.y), f(x.z), f(sx * camera.origin_px.x - 1.0),
          f(y.x), f(y.y), f(y.z), f(sy * camera.origin_px.y - 1.0),
          f(z.x), f(z.y), f(z.z), 0.0F,
          0.0F,   0.0F,   0.0F,   1.0F};
}

std::int16_t normal_part(double v) {
  return static_cast<std::int16_t>(std::lround(32767.0 * std::clamp(v, -1.0, 1.0)));
}

void add_points(const SolidBody& body, std::vector<GlPoint>& points) {
  const std::vector<Vec3> normals = point_normals(body);
  const std::vector<Rgba> colors = point_colors(body);
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    const Vec3 &p = body.points[i], &n = normals[i];
    points.push_back({{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                      {normal_part(n.x), normal_part(n.y), normal_part(n.z), 0},
                      {colors[i].r, colors[i].g, colors[i].b, 255}});
  }
}

/// Adds the triangles of a body whose first point has the index `first`.
void add_triangles(const SolidBody& body, std::uint32_t first,
                   std::vector<std::uint32_t>& triangles) {
  for (const SolidBody::Triangle& t : body.triangles) {
    for (const std::uint32_t corner : t) triangles.push_back(first + corner);
  }
}

/// Adds the edges of a body whose first point has the index `first`.
void add_lines(const SolidBody& body, std::uint32_t first, std::vector<std::uint32_t>& lines) {
  for (const SolidBody::Triangle& t : body.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      // Each edge belongs to two triangles, in opposite directions.
      const std::uint32_t next = t[(k + 1) % 3];
      if (t[k] < next) lines.insert(lines.end(), {first + t[k], first + next});
    }
  }
}

enum class ProgramKind : std::uint8_t { kWhole, kSection, kLines, kLinesOfSection };
constexpr std::size_t kPrograms = 4;

/// Returns 0 if the shader does not compile.
GLuint make_shader(QOpenGLFunctions& gl, GLenum type, const QByteArray& source) {
  const GLuint shader = gl.glCreateShader(type);
  const char* text = source.constData();
  gl.glShaderSource(shader, 1, &text, nullptr);
  gl.glCompileShader(shader);
  GLint compiles = GL_FALSE;
  gl.glGetShaderiv(shader, GL_COMPILE_STATUS, &compiles);
  if (compiles) return shader;
  gl.glDeleteShader(shader);
  return 0;
}

/// Returns 0 if the program cannot be built.
GLuint make_program(QOpenGLContext& context, ProgramKind kind) {
  QOpenGLFunctions& gl = *context.functions();
  QByteArray defines =
      context.isOpenGLES() ? "#define CENTROID\n" : "#version 120\n#define CENTROID centroid\n";
  const bool is_section = kind == ProgramKind::kSection || kind == ProgramKind::kLinesOfSection;
  if (is_section) defines += "#define SECTION\n";
  if (kind == ProgramKind::kLines || kind == ProgramKind::kLinesOfSection) {
    defines += "#define LINES\n";
  }
  const GLuint vertex = make_shader(gl, GL_VERTEX_SHADER, defines + kVertexShader),
               fragment = make_shader(gl, GL_FRAGMENT_SHADER, defines + kFragmentShader);
  const GLuint program = gl.glCreateProgram();
  gl.glAttachShader(program, vertex);
  gl.glAttachShader(program, fragment);
  gl.glBindAttribLocation(program, 0, "at");
  gl.glBindAttribLocation(program, 1, "normal");
  gl.glBindAttribLocation(program, 2, "color");
  gl.glLinkProgram(program);
  gl.glDeleteShader(vertex);
  gl.glDeleteShader(fragment);
  GLint links = GL_FALSE;
  gl.glGetProgramiv(program, GL_LINK_STATUS, &links);
  if (links) return program;
  gl.glDeleteProgram(program);
  return 0;
}

}  // namespace

/// Everything that belongs to the context.
struct SolidGl::Parts {
  QOffscreenSurface surface;
  QOpenGLContext context;
  std::array<GLuint, kPrograms> programs{};
  enum Buffer : std::size_t { kPoints, kTriangles, kLines, kBuffers };
  std::array<GLuint, kBuffers> buffers{};
  /// A fast picture is painted into the first frame. A smooth one is painted into the second frame,
  /// which has several samples for each pixel, and their mean is copied to the first one.
  std::array<GLuint, 2> frames{}, colors{}, depths{};
  QSize frame_size;
  bool has_samples = false;
  GLsizei triangle_indices = 0, line_indices = 0;
  double radius_mm = 1.0;
  GLuint texture = 0;  // the ink
  bool has_ink = false;
  std::array<float, 4> ink_place{};

  bool begin() { return context.makeCurrent(&surface); }
  [[nodiscard]] QOpenGLExtraFunctions& gl() const { return *context.extraFunctions(); }
  bool make_parts();
  bool make_frames(QSize size_px);
  void free_frames();
  void set_ink(const FrontPaint* paint);
  void set_uniforms(GLuint program, const SolidCamera& camera, const SolidLook& look);
  void draw(ProgramKind kind, const SolidCamera& camera, const SolidLook& look);
  QImage read(Quality quality);
};

std::unique_ptr<SolidGl> SolidGl::create() {
  auto parts = std::make_unique<Parts>();
  if (!parts->context.create()) return nullptr;
  parts->surface.setFormat(parts->context.format());
  parts->surface.create();
  if (!parts->surface.isValid() || !parts->begin()) return nullptr;
  std::unique_ptr<SolidGl> made(new SolidGl(std::move(parts)));
  return made->parts_->make_parts() ? std::move(made) : nullptr;
}

SolidGl::SolidGl(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

SolidGl::~SolidGl() {
  if (!parts_->begin()) return;
  for (const GLuint program : parts_->programs) parts_->gl().glDeleteProgram(program);
  parts_->gl().glDeleteBuffers(Parts::kBuffers, parts_->buffers.data());
  parts_->gl().glDeleteTextures(1, &parts_->texture);
  parts_->free_frames();
  parts_->context.doneCurrent();
}

bool SolidGl::Parts::make_parts() {
  const bool is_es = context.isOpenGLES();
  const bool is_3 = context.format().majorVersion() >= 3;
  if (is_es && !is_3 && !context.hasExtension("GL_OES_element_index_uint")) return false;
  if (!is_es && !is_3 && !context.hasExtension("GL_ARB_framebuffer_object")) return false;
  has_samples = !is_es || is_3;
  for (std::size_t i = 0; i < kPrograms; ++i) {
    programs[i] = make_program(context, static_cast<ProgramKind>(i));
    if (programs[i] == 0) return false;
  }
  gl().glGenBuffers(kBuffers, buffers.data());
  gl().glGenTextures(1, &texture);
  return true;
}

/// OpenGL ES 2.0 shows textures of any size only without levels and repetition. Rows of RGBA need
/// no alignment. A picture that is too large for this OpenGL is left out.
void SolidGl::Parts::set_ink(const FrontPaint* paint) {
  GLint largest = 0;
  gl().glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  has_ink = paint != nullptr && std::max(paint->ink.width(), paint->ink.height()) <= largest;
  if (!has_ink) return;
  const Image& ink = paint->ink;
  gl().glBindTexture(GL_TEXTURE_2D, texture);
  gl().glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl().glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl().glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl().glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl().glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, ink.width(), ink.height(), 0, GL_RGBA,
                    GL_UNSIGNED_BYTE, ink.bytes().data());
  const Vec origin = paint->to_px({}), mm = paint->to_px({1.0, 1.0, 0.0}) - origin;
  const auto share = [](double px, int of) { return static_cast<float>(px / of); };
  ink_place = {share(origin.x, ink.width()), share(origin.y, ink.height()),
               share(mm.x, ink.width()), share(mm.y, ink.height())};
}

void SolidGl::set_solid(const Solid& solid, const FrontPaint* paint) {
  if (!parts_->begin()) return;
  parts_->set_ink(paint);
  std::vector<GlPoint> points;
  std::vector<std::uint32_t> triangles, lines;
  double radius_mm = 0.0;
  for (const SolidBody& body : solid.bodies) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const SolidBody shaded = split_at_creases(body);
    add_points(shaded, points);
    add_triangles(shaded, first, triangles);
    add_lines(body, first, lines);
    for (const Vec3& p : body.points) radius_mm = std::max(radius_mm, norm(p));
  }
  const auto fill = [this](GLenum target, Parts::Buffer buffer, const auto& data) {
    parts_->gl().glBindBuffer(target, parts_->buffers[buffer]);
    parts_->gl().glBufferData(target,
                              static_cast<qopengl_GLsizeiptr>(data.size() * sizeof(data[0])),
                              data.data(), GL_STATIC_DRAW);
  };
  fill(GL_ARRAY_BUFFER, Parts::kPoints, points);
  fill(GL_ELEMENT_ARRAY_BUFFER, Parts::kTriangles, triangles);
  fill(GL_ELEMENT_ARRAY_BUFFER, Parts::kLines, lines);
  parts_->triangle_indices = static_cast<GLsizei>(triangles.size());
  parts_->line_indices = static_cast<GLsizei>(lines.size());
  parts_->radius_mm = radius_mm;
}

void SolidGl::Parts::free_frames() {
  gl().glDeleteFramebuffers(2, frames.data());
  gl().glDeleteRenderbuffers(2, colors.data());
  gl().glDeleteRenderbuffers(2, depths.data());
  frames = colors = depths = {};
}

bool SolidGl::Parts::make_frames(QSize size_px) {
  if (frame_size == size_px) return true;
  free_frames();
  frame_size = {};
  const auto make = [this, size_px](GLuint& buffer, GLenum format, GLenum attachment, int samples) {
    gl().glGenRenderbuffers(1, &buffer);
    gl().glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    if (samples > 0) {
      gl().glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size_px.width(),
                                            size_px.height());
    } else {
      gl().glRenderbufferStorage(GL_RENDERBUFFER, format, size_px.width(), size_px.height());
    }
    gl().glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  };
  const GLenum color = has_samples ? GL_RGBA8 : GL_RGBA4;  // OpenGL ES 2.0 has no other
  const GLenum deep = has_samples ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT16;
  GLint max_samples = 1;
  if (has_samples) gl().glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
  gl().glGenFramebuffers(2, frames.data());
  for (std::size_t i = 0; i < (has_samples ? 2U : 1U); ++i) {
    const int samples = i == 0 ? 0 : std::min(kSamplesPerPixel, static_cast<int>(max_samples));
    gl().glBindFramebuffer(GL_FRAMEBUFFER, frames[i]);
    make(colors[i], color, GL_COLOR_ATTACHMENT0, samples);
    make(depths[i], deep, GL_DEPTH_ATTACHMENT, samples);
    if (gl().glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
  }
  frame_size = size_px;
  return true;
}

void SolidGl::Parts::set_uniforms(GLuint program, const SolidCamera& camera,
                                  const SolidLook& look) {
  const auto set = [this, program](const char* name, const Vec3& v) {
    gl().glUniform3f(gl().glGetUniformLocation(program, name), static_cast<float>(v.x),
                     static_cast<float>(v.y), static_cast<float>(v.z));
  };
  const Vec3 lamp = -0.45 * camera.right + 0.55 * camera.up + 0.70 * camera.towards;
  const Vec3 to_lamp = (1.0 / norm(lamp)) * lamp, half = to_lamp + camera.towards;
  gl().glUniformMatrix4fv(gl().glGetUniformLocation(program, "to_clip"), 1, GL_FALSE,
                          to_clip(camera, frame_size, radius_mm).constData());
  set("to_lamp", to_lamp);
  set("half_way", (1.0 / norm(half)) * half);
  set("up", camera.up);
  set("towards", camera.towards);
  set("cut_color", {kCutColor[0], kCutColor[1], kCutColor[2]});
  gl().glUniform1i(gl().glGetUniformLocation(program, "has_ink"), has_ink ? 1 : 0);
  gl().glUniform1i(gl().glGetUniformLocation(program, "ink"), 0);
  gl().glUniform4f(gl().glGetUniformLocation(program, "ink_place"), ink_place[0], ink_place[1],
                   ink_place[2], ink_place[3]);
  gl().glActiveTexture(GL_TEXTURE0);
  gl().glBindTexture(GL_TEXTURE_2D, texture);
  gl().glUniform1f(gl().glGetUniformLocation(program, "section_mm"),
                   static_cast<float>(look.section_x_mm.value_or(0.0)));
}

void SolidGl::Parts::draw(ProgramKind kind, const SolidCamera& camera, const SolidLook& look) {
  const bool is_lines = kind == ProgramKind::kLines || kind == ProgramKind::kLinesOfSection;
  const GLuint program = programs[static_cast<std::size_t>(kind)];
  gl().glUseProgram(program);
  set_uniforms(program, camera, look);
  gl().glBindBuffer(GL_ARRAY_BUFFER, buffers[kPoints]);
  const auto attribute = [this](GLuint index, GLenum type, GLboolean normalized,
                                std::size_t offset) {
    gl().glEnableVertexAttribArray(index);
    // OpenGL wants the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* const at = reinterpret_cast<const void*>(offset);
    gl().glVertexAttribPointer(index, 3, type, normalized, sizeof(GlPoint), at);
  };
  attribute(0, GL_FLOAT, GL_FALSE, offsetof(GlPoint, at));
  attribute(1, GL_SHORT, GL_TRUE, offsetof(GlPoint, normal));
  attribute(2, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(GlPoint, color));
  gl().glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[is_lines ? kLines : kTriangles]);
  gl().glDrawElements(is_lines ? GL_LINES : GL_TRIANGLES,
                      is_lines ? line_indices : triangle_indices, GL_UNSIGNED_INT, nullptr);
}

QImage SolidGl::Parts::read(Quality quality) {
  const int width = frame_size.width(), height = frame_size.height();
  if (has_samples && quality == Quality::kSmooth) {
    gl().glBindFramebuffer(GL_READ_FRAMEBUFFER, frames[1]);
    gl().glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frames[0]);
    gl().glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
    gl().glBindFramebuffer(GL_FRAMEBUFFER, frames[0]);
  }
  // The order of the bytes that a window shows without conversion. OpenGL ES has only the other.
  constexpr GLenum kBgra = 0x80E1;
  const bool is_desktop = !context.isOpenGLES();
  QImage image(frame_size, is_desktop ? QImage::Format_RGB32 : QImage::Format_RGBX8888);
  gl().glReadPixels(0, 0, width, height, is_desktop ? kBgra : GL_RGBA, GL_UNSIGNED_BYTE,
                    image.bits());
  return gl().glGetError() == GL_NO_ERROR ? image : QImage();
}

QImage SolidGl::paint(const SolidCamera& camera, const SolidLook& look, QSize size_px,
                      Quality quality) {
  if (!parts_->begin() || !parts_->make_frames(size_px)) return {};
  QOpenGLFunctions& gl = parts_->gl();
  const bool is_smooth = parts_->has_samples && quality == Quality::kSmooth;
  gl.glBindFramebuffer(GL_FRAMEBUFFER, parts_->frames[is_smooth ? 1 : 0]);
  gl.glViewport(0, 0, size_px.width(), size_px.height());
  const auto part = [](std::uint8_t v) { return static_cast<float>(v) / 255.0F; };
  gl.glClearColor(part(look.paper.r), part(look.paper.g), part(look.paper.b), 1.0F);
  gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.glEnable(GL_DEPTH_TEST);
  gl.glDepthFunc(GL_LEQUAL);
  gl.glFrontFace(GL_CW);  // the picture is upside down
  const bool is_cut = look.section_x_mm.has_value();
  const bool has_lines = look.wireframe == WireframeChoice::kShow &&
                         (is_smooth || parts_->line_indices / 2 <= kMaxFastLines);
  is_cut ? gl.glDisable(GL_CULL_FACE) : gl.glEnable(GL_CULL_FACE);
  has_lines ? gl.glEnable(GL_POLYGON_OFFSET_FILL) : gl.glDisable(GL_POLYGON_OFFSET_FILL);
  gl.glPolygonOffset(1.0F, 1.0F);
  parts_->draw(is_cut ? ProgramKind::kSection : ProgramKind::kWhole, camera, look);
  if (has_lines) {
    parts_->draw(is_cut ? ProgramKind::kLinesOfSection : ProgramKind::kLines, camera, look);
  }
  return parts_->read(quality);
}

}  // namespace felt::desktop
