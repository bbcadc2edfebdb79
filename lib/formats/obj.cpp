#include "formats/obj.h"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <limits>
#include <streambuf>
#include <utility>

#include "formats/json_text.h"
#include "formats/output_file.h"
#include "formats/word_reader.h"
#include "scene/planarity.h"
#include "scene/progress.h"

namespace raytree {
namespace {

/// tinyobjloader counts a face's vertices in one byte.
constexpr std::size_t kMostCorners = 255;

/// Goes over the text before the library does. The library takes the nearby double, not the
/// nearest, and 0 for a number that is none; so the numbers are taken from here, and the library is
/// handed the lines that matter and are known to be right.
class StrictPass {
  public:
    StrictPass(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

    void run();

    std::vector<Point> vertices;
    std::vector<Point> normals;
    std::string lines;  ///< v, vn, vt and f, without comments

  private:
    struct Highest {
        long long index = 0;
        std::size_t line = 0;
    };

    std::string_view next_line();
    void take(std::string_view line);
    Point point(std::string_view words, std::string_view what) const;
    void face(std::string_view words);
    void corner(std::string_view word);
    void index(std::string_view digits, std::size_t count, Highest& highest,
               std::string_view word) const;
    void check_highest(const Highest& highest, std::size_t count, const char* what) const;
    [[noreturn]] void fail(std::size_t line, const std::string& text) const {
        throw InputError(file_, "line " + std::to_string(line), text);
    }

    std::string_view text_;
    std::string file_;
    std::size_t line_ = 0;
    std::size_t texture_points_ = 0;
    Highest highest_vertex_, highest_texture_point_, highest_normal_;
};

constexpr std::string_view kBlanks = " \t";

/// Takes the first word off the front of `words`; empty at the end.
std::string_view take_word(std::string_view& words) {
    words.remove_prefix(std::min(words.find_first_not_of(kBlanks), words.size()));
    const std::string_view word = words.substr(0, words.find_first_of(kBlanks));
    words.remove_prefix(word.size());
    return word;
}

void StrictPass::run() {
    const std::size_t size = text_.size();
    lines.reserve(size);
    ProgressCounter progress("reading");
    while (!text_.empty()) {
        progress.at(size - text_.size(), size);
        ++line_;
        take(next_line());
    }
    check_highest(highest_vertex_, vertices.size(), "vertices");
    check_highest(highest_texture_point_, texture_points_, "texture points");
    check_highest(highest_normal_, normals.size(), "vertex normals");
}

/// Lines end as the library has it: in a line feed, a carriage return, or both.
std::string_view StrictPass::next_line() {
    const std::size_t end = std::min(text_.find_first_of("\n\r"), text_.size());
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end);
    text_.remove_prefix(text_.starts_with("\r\n") ? 2 : text_.empty() ? 0 : 1);
    return line.substr(0, line.find('#'));
}

void StrictPass::take(std::string_view line) {
    std::string_view words = line;
    const std::string_view keyword = take_word(words);
    if (keyword == "v") {
        vertices.push_back(point(words, "a vertex, v x y z"));
    } else if (keyword == "vn") {
        normals.push_back(point(words, "a vertex normal, vn x y z"));
    } else if (keyword == "vt") {
        ++texture_points_;
    } else if (keyword == "f") {
        face(words);
    } else {
        return;
    }
    lines += line;
    lines += '\n';
}

/// Further numbers, as of a weight or a colour, are not used but must be numbers.
Point StrictPass::point(std::string_view words, std::string_view what) const {
    Point point(0);
    int count = 0;
    for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
        double number = 0;
        if (!parse_number(word, number)) {
            fail(line_, "found " + json_string(word.substr(0, 40)) +
                            ", must be a finite number: " + std::string(what));
        }
        if (count < 3) {
            point[count] = number;
        }
        ++count;
    }
    if (count < 3) {
        fail(line_, "found " + std::to_string(count) + " numbers, must be 3: " + std::string(what));
    }
    return point;
}

void StrictPass::face(std::string_view words) {
    std::size_t corners = 0;
    for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
        corner(word);
        ++corners;
    }
    if (corners < 3 || corners > kMostCorners) {
        fail(line_, "found a face of " + std::to_string(corners) + " vertices, must be from 3 to " +
                        std::to_string(kMostCorners));
    }
}

/// One of: v, v/vt, v//vn, v/vt/vn.
void StrictPass::corner(std::string_view word) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    index(word.substr(0, slash), vertices.size(), highest_vertex_, word);
    if (slash == word.size()) {
        return;
    }
    const std::string_view rest = word.substr(slash + 1);
    const std::size_t second = std::min(rest.find('/'), rest.size());
    if (second > 0 || second == rest.size()) {
        index(rest.substr(0, second), texture_points_, highest_texture_point_, word);
    }
    if (second < rest.size()) {
        index(rest.substr(second + 1), normals.size(), highest_normal_, word);
    }
}

/// Checks an index: from 1, or from -1 backwards from the last so far. One forward may still come
/// to be right, so the highest is noted.
void StrictPass::index(std::string_view digits, std::size_t count, Highest& highest,
                       std::string_view word) const {
    long long number = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number);
    if (error != std::errc() || stop != end || number == 0 ||
        number > std::numeric_limits<int>::max()) {
        fail(line_, "found " + json_string(word.substr(0, 40)) +
                        " in a face, must be v, v/vt, v//vn or v/vt/vn with whole numbers from 1, "
                        "or from -1 backwards");
    }
    if (number < -static_cast<long long>(count)) {
        fail(line_,
             "the index " + std::to_string(number) + " in a face goes back before the first");
    }
    if (number > highest.index) {
        highest = {number, line_};
    }
}

void StrictPass::check_highest(const Highest& highest, std::size_t count, const char* what) const {
    if (highest.index > static_cast<long long>(count)) {
        fail(highest.line, "the index " + std::to_string(highest.index) +
                               " in a face is out of range: there are " + std::to_string(count) +
                               " " + what);
    }
}

/// Fans the faces of one of the library's shapes; counts what it leaves out.
class Fan {
  public:
    Fan(Mesh& mesh, std::size_t& without_area) : mesh_(mesh), without_area_(without_area) {}

    void add_faces(const tinyobj::mesh_t& faces) {
        std::size_t first = 0;
        for (const unsigned char count : faces.num_face_vertices) {
            for (std::size_t k = 1; k + 1 < count; ++k) {
                add({corner(faces.indices[first]), corner(faces.indices[first + k]),
                     corner(faces.indices[first + k + 1])});
            }
            first += count;
        }
    }

  private:
    static Mesh::Corner corner(const tinyobj::index_t& index) {
        return {index.vertex_index, index.normal_index};
    }
    const Point& vertex(const Mesh::Corner& corner) const {
        return mesh_.vertices[static_cast<std::size_t>(corner.vertex)];
    }
    bool has_normal(const Mesh::Corner& corner) const {
        return corner.normal >= 0 &&
               mesh_.normals[static_cast<std::size_t>(corner.normal)] != Point(0);
    }
    void add(Mesh::Triangle triangle) {
        const std::array<Point, 3> points{vertex(triangle[0]), vertex(triangle[1]),
                                          vertex(triangle[2])};
        if (!planarity_of(points).has_area()) {
            ++without_area_;
            return;
        }
        // A triangle that lacks a normal is flat.
        if (!std::all_of(triangle.begin(), triangle.end(),
                         [&](const Mesh::Corner& c) { return has_normal(c); })) {
            for (Mesh::Corner& c : triangle) {
                c.normal = -1;
            }
        }
        mesh_.triangles.push_back(triangle);
    }

    Mesh& mesh_;
    std::size_t& without_area_;
};

/// Text as a stream that tells how far it has been read.
class ToldText : public std::streambuf {
  public:
    explicit ToldText(std::string& text) : text_(text) {}

  private:
    int_type underflow() override {
        constexpr std::size_t piece = 1 << 16;
        if (given_ == text_.size()) {
            return traits_type::eof();
        }
        tell_progress("reading faces",
                      static_cast<double>(given_) / static_cast<double>(text_.size()));
        char* const begin = text_.data() + given_;
        given_ += std::min(piece, text_.size() - given_);
        setg(begin, begin, text_.data() + given_);
        return traits_type::to_int_type(*begin);
    }

    std::string& text_;
    std::size_t given_ = 0;
};

std::vector<tinyobj::shape_t> library_shapes(std::string lines, const std::string& file) {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning;
    std::string error;
    ToldText told(lines);
    std::istream stream(&told);
    stream.exceptions(std::ios::badbit);  // what a listener throws goes on
    constexpr bool triangulate = false;
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr,
                          triangulate, false)) {
        throw InputError(file, "", "is no Wavefront OBJ file that can be read: " + error);
    }
    return shapes;
}

}  // namespace

Mesh read_obj(std::string_view text, const std::filesystem::path& file,
              std::vector<std::string>& warnings) {
    StrictPass strict(text, file.string());
    strict.run();
    Mesh mesh;
    mesh.file = file.filename().string();
    mesh.vertices = std::move(strict.vertices);
    mesh.normals = std::move(strict.normals);
    std::size_t without_area = 0;
    Fan fan(mesh, without_area);
    for (const tinyobj::shape_t& shape : library_shapes(std::move(strict.lines), file.string())) {
        fan.add_faces(shape.mesh);
    }
    if (mesh.triangles.empty()) {
        throw InputError(file.string(), "", "the mesh is empty: it has no face with an area");
    }
    if (without_area > 0) {
        warnings.push_back(file.string() + ": " + std::to_string(without_area) +
                           (without_area == 1 ? " triangle has no area and is left out"
                                              : " triangles have no area and are left out"));
    }
    return mesh;
}

Mesh load_obj(const std::filesystem::path& file, std::vector<std::string>& warnings) {
    return read_obj(read_input(file), file, warnings);
}

}  // namespace raytree
