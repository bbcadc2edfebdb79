#include <cmath>

#include "accuracy/study.h"
#include "formats/json_text.h"
#include "formats/output_file.h"
#include "support/report.h"

namespace raytree::bench {
namespace {

using Layout = JsonWriter::Layout;

void put(JsonWriter& json, const char* key, const Errors& errors) {
    json.key(key).begin_object();
    json.member("worst", errors.worst);
    json.key("rms");
    if (errors.count > 0) {
        json.value(errors.rms());
    } else {
        json.null();
    }
    json.end_object();
}

void put(JsonWriter& json, const WorkPoint& p) {
    json.begin_object().member("family", p.family).member("label", p.label);
    json.member("seconds_a_pixel", p.seconds).member("low", p.low).member("high", p.high);
    put(json, "intensity", p.intensity);
    json.key("pixels_of_other_shape");
    if (std::isfinite(p.other_shape)) {
        json.value(p.other_shape);
    } else {
        json.null();
    }
    json.member("on_front", p.on_front).end_object();
}

void put(JsonWriter& json, const Rounding& r) {
    json.begin_object(Layout::block).member("arithmetic", r.name);
    put(json, "distance", r.distance);
    put(json, "point", r.place);
    put(json, "intensity", r.intensity);
    json.member("pixels_of_other_shape", static_cast<double>(r.other_shape));
    json.key("direction_after_bounces").begin_array(Layout::block);
    for (const Errors& errors : r.direction) {
        json.begin_object().member("worst", errors.worst);
        json.member("rms", errors.rms()).end_object();
    }
    json.end_array().end_object();
}

}  // namespace

void Study::write(const std::string& file) const {
    JsonWriter json;
    json.begin_object(Layout::block);
    json.member("format", "raytree-accuracy/1.0").member("scene", subject_.title);
    json.member("machine", machine_text()).member("rounds", options_.rounds);
    json.member("width", subject_.scene.camera.width);
    json.member("height", subject_.scene.camera.height);
    json.member("truth_depth", truth_depth_).member("verdict", verdict_);
    json.member("without_embree", embree_why_not_).member("without_povray", povray_why_not_);
    json.key("points").begin_array(Layout::block);
    for (const WorkPoint& point : points_) {
        put(json, point);
    }
    json.end_array().key("rounding").begin_array(Layout::block);
    for (const Rounding& rounding : roundings_) {
        put(json, rounding);
    }
    json.end_array().end_object();
    write_output(file, json.take());
}

}  // namespace raytree::bench
