#include "check/picture_mistakes.h"

#include <cmath>

namespace raytree::check {
namespace {

constexpr std::string_view topic = "pictures";

template <class Change> Spectrum each(const Spectrum& c, Change change) {
    return {change(c.r), change(c.g), change(c.b)};
}

const PictureMistakeRow rows[] = {
    {"out.uchar_wrap",
     "Colours above 1 are not clamped before they become 8 bits: they wrap round.", topic,
     [](const Picture& truth, PixelPlace at) {
         return each(truth.at(at.i, at.j), [](double x) {
             const double level = std::fmod(std::floor(255 * x), 256);
             return (level < 0 ? level + 256 : level) / 255;
         });
     }},
    {"out.gamma", "A gamma curve is applied to the finished picture.", topic,
     [](const Picture& truth, PixelPlace at) {
         return each(truth.at(at.i, at.j),
                     [](double x) { return std::pow(std::max(0.0, x), 1 / 2.2); });
     }},
    {"out.gamma_2", "The square root of each colour is taken for the finished picture.", topic,
     [](const Picture& truth, PixelPlace at) {
         return each(truth.at(at.i, at.j), [](double x) { return std::sqrt(std::max(0.0, x)); });
     }},
    {"out.bgr", "Red and blue are exchanged in the finished picture.", topic,
     [](const Picture& truth, PixelPlace at) {
         const Spectrum& c = truth.at(at.i, at.j);
         return Spectrum(c.b, c.g, c.r);
     }},
    {"out.row_order", "The rows of the finished picture are written from below.", topic,
     [](const Picture& truth, PixelPlace at) { return truth.at(at.i, truth.height - 1 - at.j); }},
    {"out.column_order", "The columns of the finished picture are written from the right.", topic,
     [](const Picture& truth, PixelPlace at) { return truth.at(truth.width - 1 - at.i, at.j); }},
    {"out.turned_round", "The finished picture is turned by half a turn.", topic,
     [](const Picture& truth, PixelPlace at) {
         return truth.at(truth.width - 1 - at.i, truth.height - 1 - at.j);
     }},
    {"out.grey", "One channel is written for all three.", topic,
     [](const Picture& truth, PixelPlace at) { return Spectrum(truth.at(at.i, at.j).r); }},
};

}  // namespace

std::span<const PictureMistakeRow> picture_mistakes() { return rows; }

}  // namespace raytree::check
