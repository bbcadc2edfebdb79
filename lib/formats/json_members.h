#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

#include "formats/json_reader.h"
#include "trace/reason.h"

namespace raytree {

/// The members of one object where all are optional: one that is `null` counts as absent. Each
/// function reads one member into `out`, leaves `out` alone where there is none, and tells whether
/// there was one; a wrong type is reported.
class OptionalMembers {
  public:
    OptionalMembers(const Json& object, const JsonPlace& place, JsonReport& report)
        : reader_(object, place, report), report_(report) {}

    bool gives(std::string_view key) const {
        const Json* const value = reader_.find(key);
        return value != nullptr && !value->is_null();
    }
    bool text(std::string_view key, std::string& out) const {
        return gives(key) && reader_.text(key, out, Need::optional);
    }
    bool number(std::string_view key, double& out) const {
        return gives(key) && reader_.number(key, out, Need::optional);
    }
    bool count(std::string_view key, std::size_t& out) const {
        std::int64_t number = 0;
        const bool read = gives(key) && reader_.whole_number(key, number, Need::optional, 0,
                                                             std::int64_t{1} << 53);
        out = read ? static_cast<std::size_t>(number) : out;
        return read;
    }
    bool point(std::string_view key, Vec3<double>& out) const {
        return gives(key) && reader_.point(key, out, Need::optional);
    }
    bool colour(std::string_view key, Rgb<double>& out) const {
        return gives(key) && reader_.colour(key, out, Need::optional);
    }
    bool numbers(std::string_view key, std::size_t n, double* out) const {
        return gives(key) && reader_.numbers(key, n, out, Need::optional);
    }
    std::optional<Reason> reason(std::string_view key) const {
        static const ObjectReader::Words words = [] {
            ObjectReader::Words all;
            std::ranges::transform(reason_texts(), std::back_inserter(all), &ReasonText::word);
            return all;
        }();
        std::size_t place = 0;
        if (!gives(key) || !reader_.choice(key, words, place, Need::optional)) {
            return std::nullopt;
        }
        return static_cast<Reason>(place);
    }
    std::size_t choice(std::string_view key, const ObjectReader::Words& words) const {
        std::size_t place = 0;
        if (gives(key)) {
            reader_.choice(key, words, place, Need::optional);
        }
        return place;
    }
    /// Calls `read` with the members of the object under `key`, if there is one.
    template <class Read> bool object(std::string_view key, Read read) const {
        if (!gives(key)) {
            return false;
        }
        const JsonPlace place = reader_.place_of(key);
        const Json& value = *reader_.find(key);
        if (ObjectReader::is_object(value, place, report_)) {
            read(OptionalMembers(value, place, report_));
        }
        return true;
    }
    template <class Read> void list(std::string_view key, Read read) const {
        if (!gives(key)) {
            return;
        }
        const JsonPlace place = reader_.place_of(key);
        const Json& value = *reader_.find(key);
        if (!value.is_array()) {
            report_.add(place, "found " + shown(value) + ", must be a list of objects");
            return;
        }
        for (std::size_t k = 0; k < value.size(); ++k) {
            const JsonPlace at = place.element(k);
            if (ObjectReader::is_object(value[k], at, report_)) {
                read(OptionalMembers(value[k], at, report_));
            }
        }
    }
    const ObjectReader& reader() const { return reader_; }

  private:
    ObjectReader reader_;
    JsonReport& report_;
};

}  // namespace raytree
