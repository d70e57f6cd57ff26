#include "batten/base/error.hpp"
#include "batten/io/curve_file.hpp"
#include "io/exchange/entries.hpp"

namespace batten {
namespace {

/// A format of files of several curves: under which key they stand, and in each entry there.
struct ListFormat {
    const char* name;
    const char* key;
    const char* curve;  ///< null: the entry is the curve
};
constexpr ListFormat list_formats[] = {{"batten.curves/1", "curves", nullptr},
                                       {"batten.contours/1", "lines", "curve"}};

const ListFormat* list_format_of(const Value& tree) {
    const Value* format = tree.find("format");
    const std::string* name = format ? format->text() : nullptr;
    for (const ListFormat& each : list_formats) {
        if (name && *name == each.name) return &each;
    }
    return nullptr;
}

}  // namespace

std::vector<Curve> curves_of(const Value& tree, const std::string& place) {
    const ListFormat* format = list_format_of(tree);
    if (!format) return {curve_of(tree, place)};
    const exchange::Entries entries(tree, place);
    const ValueList& list = entries.list(format->key);
    std::vector<Curve> curves;
    for (const Value& each : list) {
        const std::string entry = exchange::Entries::at(format->key, curves.size());
        const Value* curve = format->curve ? each.find(format->curve) : &each;
        if (!curve) throw entries.wrong(entry, &each, "a map with a curve is needed here");
        curves.push_back(curve_of(*curve, entries.place(entry)));
    }
    if (curves.empty()) {
        throw entries.wrong(format->key, tree.find(format->key), "at least one curve is needed here");
    }
    return curves;
}

Value curves_value(const std::vector<Curve>& curves) {
    ValueList list;
    for (const Curve& curve : curves) list.push_back(curve_value(curve));
    return ValueMap{{"format", list_formats[0].name}, {list_formats[0].key, std::move(list)}};
}

const Curve& one_curve(const std::vector<Curve>& curves, const std::string& place) {
    if (curves.size() == 1) return curves.front();
    throw Error("curve.several", place, std::to_string(curves.size()) + " curves",
                "one curve is needed here: `convert FILE --only K` writes that number K, from 0");
}

}  // namespace batten
