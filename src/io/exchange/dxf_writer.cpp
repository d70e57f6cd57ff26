#include "io/exchange/dxf_writer.hpp"

#include <array>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::dxf_file {
namespace {

int unit_code(DxfUnits units) {
    switch (units) {
        case DxfUnits::none: return 0;
        case DxfUnits::inch: return 1;
        case DxfUnits::mm: return 4;
        case DxfUnits::cm: return 5;
        case DxfUnits::m: return 6;
    }
    return 0;
}

void begin(Pairs& out, std::string_view section) { out.add(0, "SECTION").add(2, section); }
void end(Pairs& out) { out.add(0, "ENDSEC"); }

void header(Pairs& out, const DxfOptions& options, std::string_view next_handle) {
    const bool is_r12 = options.version == DxfVersion::r12;
    begin(out, "HEADER");
    out.add(9, "$ACADVER").add(1, is_r12 ? "AC1009" : "AC1015");
    if (!is_r12) {
        out.add(9, "$HANDSEED").add(5, next_handle);
        out.add(9, "$INSUNITS").add(70, unit_code(options.units));
    }
    end(out);
}

/// The tables of R12: what a layer refers to.
void old_tables(Pairs& out, const std::string& layer) {
    begin(out, "TABLES");
    out.add(0, "TABLE").add(2, "LTYPE").add(70, 1);
    out.add(0, "LTYPE").add(2, "CONTINUOUS").add(70, 0).add(3, "Solid line");
    out.add(72, 65).add(73, 0).add(40, 0.0).add(0, "ENDTAB");
    out.add(0, "TABLE").add(2, "LAYER").add(70, layer == "0" ? 1 : 2);
    out.add(0, "LAYER").add(2, "0").add(70, 0).add(62, 7).add(6, "CONTINUOUS");
    if (layer != "0") out.add(0, "LAYER").add(2, layer).add(70, 0).add(62, 7).add(6, "CONTINUOUS");
    out.add(0, "ENDTAB");
    end(out);
}

/// One table of R2000 and its records, each made by `record(handle)`.
class Table {
public:
    Table(Pairs& out, std::string_view name, std::string_view handle, int records)
        : out_(out), name_(name), handle_(handle) {
        out.add(0, "TABLE").add(2, name).add(5, handle).add(330, "0");
        out.add(100, "AcDbSymbolTable").add(70, records);
        if (name == "DIMSTYLE") out.add(100, "AcDbDimStyleTable");
    }
    ~Table() { out_.add(0, "ENDTAB"); }
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;

    Pairs& record(std::string_view handle, std::string_view kind, std::string_view name) {
        out_.add(0, name_).add(5, handle).add(330, handle_);
        return out_.add(100, "AcDbSymbolTableRecord").add(100, kind).add(2, name);
    }

private:
    Pairs& out_;
    std::string name_, handle_;
};

void linetypes(Pairs& out) {
    Table table(out, "LTYPE", "2", 3);
    for (const auto& [handle, name, text] :
         {std::array<std::string_view, 3>{"10", "ByBlock", ""}, {"11", "ByLayer", ""},
          {"12", "Continuous", "Solid line"}}) {
        table.record(handle, "AcDbLinetypeTableRecord", name).add(70, 0).add(3, text);
        out.add(72, 65).add(73, 0).add(40, 0.0);
    }
}

void layers(Pairs& out, const std::string& layer, Handles& handles) {
    Table table(out, "LAYER", "3", layer == "0" ? 1 : 2);
    const auto add = [&](std::string_view handle, std::string_view name) {
        table.record(handle, "AcDbLayerTableRecord", name);
        out.add(70, 0).add(62, 7).add(6, "Continuous");
    };
    add("13", "0");
    if (layer != "0") add(handles.next(), layer);
}

void styles(Pairs& out) {
    Table table(out, "STYLE", "4", 1);
    table.record("14", "AcDbTextStyleTableRecord", "Standard").add(70, 0).add(40, 0.0);
    out.add(41, 1.0).add(50, 0.0).add(71, 0).add(42, 1.0).add(3, "txt").add(4, "");
}

void tables(Pairs& out, const std::string& layer, Handles& handles) {
    begin(out, "TABLES");
    { Table table(out, "VPORT", "1", 0); }
    linetypes(out);
    layers(out, layer, handles);
    styles(out);
    { Table table(out, "VIEW", "5", 0); }
    { Table table(out, "UCS", "6", 0); }
    {
        Table table(out, "APPID", "7", 1);
        table.record("15", "AcDbRegAppTableRecord", "ACAD").add(70, 0);
    }
    { Table table(out, "DIMSTYLE", "8", 0); }
    {
        Table table(out, "BLOCK_RECORD", "9", 2);
        table.record(model_space, "AcDbBlockTableRecord", "*Model_Space");
        table.record("1C", "AcDbBlockTableRecord", "*Paper_Space");
    }
    end(out);
}

struct Block {
    std::string_view name, record, begin, end;
    bool is_paper;
};

void blocks(Pairs& out) {
    begin(out, "BLOCKS");
    for (const Block& block : {Block{"*Model_Space", model_space, "16", "17", false},
                               Block{"*Paper_Space", "1C", "18", "19", true}}) {
        const auto owner = [&](std::string_view kind, std::string_view handle) {
            out.add(0, kind).add(5, handle).add(330, block.record).add(100, "AcDbEntity");
            if (block.is_paper) out.add(67, 1);
            out.add(8, "0");
        };
        owner("BLOCK", block.begin);
        out.add(100, "AcDbBlockBegin").add(2, block.name).add(70, 0);
        out.add(10, 0.0).add(20, 0.0).add(30, 0.0).add(3, block.name).add(1, "");
        owner("ENDBLK", block.end);
        out.add(100, "AcDbBlockEnd");
    }
    end(out);
}

void objects(Pairs& out) {
    begin(out, "OBJECTS");
    out.add(0, "DICTIONARY").add(5, "C").add(330, "0").add(100, "AcDbDictionary").add(281, 1);
    out.add(3, "ACAD_GROUP").add(350, "D");
    out.add(0, "DICTIONARY").add(5, "D").add(330, "C").add(100, "AcDbDictionary").add(281, 1);
    end(out);
}

}  // namespace

Pairs& Pairs::add(int code, std::string_view text) {
    text_ += std::to_string(code);
    text_ += '\n';
    text_ += text;
    text_ += '\n';
    return *this;
}

Pairs& Pairs::add(int code, double number) {
    if (!std::isfinite(number)) {
        throw Error("number.overflow", "group code " + std::to_string(code), "beyond a double",
                    "scale the curve down");
    }
    return add(code, format_number(number));
}

std::string Handles::next() {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text;
    for (unsigned rest = ++last_; rest > 0; rest /= 16) text.insert(text.begin(), digits[rest % 16]);
    return text;
}

std::string document(const std::string& entities, const DxfOptions& options, Handles& handles) {
    const bool is_r12 = options.version == DxfVersion::r12;
    Pairs body;
    if (is_r12) {
        old_tables(body, options.layer);
    } else {
        tables(body, options.layer, handles);
        blocks(body);
    }
    begin(body, "ENTITIES");
    Pairs tail;
    end(tail);
    if (!is_r12) objects(tail);
    tail.add(0, "EOF");
    Pairs head;
    header(head, options, handles.next());
    return head.text() + body.text() + entities + tail.text();
}

}  // namespace batten::dxf_file
