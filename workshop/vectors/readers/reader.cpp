// Reads a pack of vectors: g++ -O2 -std=c++17 -ffp-contract=off reader.cpp -o reader && ./reader near.json
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

// enough of JSON for a pack
struct Value {
    std::string text;  // of strings and numbers
    std::vector<Value> list;
    std::map<std::string, Value> fields;
    const Value& operator[](const char* name) const { return fields.at(name); }
    std::vector<Value> list_of(const char* name) const {
        return fields.count(name) ? fields.at(name).list : std::vector<Value>();
    }
    double number() const { return std::strtod(text.c_str(), nullptr); }  // hexadecimal doubles too
};

struct Parser {
    const char* at;
    void space() { while (*at == ' ' || *at == '\n') ++at; }
    std::string quoted() {
        std::string found;
        for (++at; *at != '"'; ++at) {
            if (*at == '\\') found += *at++;
            found += *at;
        }
        ++at;
        return found;
    }
    Value value() {
        Value found;
        space();
        if (*at == '"') {
            found.text = quoted();
        } else if (*at == '[' || *at == '{') {
            const bool object = *at++ == '{';
            for (space(); *at != ']' && *at != '}'; space()) {
                if (*at == ',') { ++at; continue; }
                if (!object) { found.list.push_back(value()); continue; }
                const std::string name = quoted();
                space();
                ++at;  // the colon
                found.fields[name] = value();
            }
            ++at;
        } else {
            while (*at && *at != ',' && *at != ']' && *at != '}' && *at != ' ' && *at != '\n') found.text += *at++;
        }
        return found;
    }
};

std::uint32_t crc32(const std::string& text) {
    std::uint32_t crc = ~0u;
    for (unsigned char c : text) {
        crc ^= c;
        for (int k = 0; k < 8; ++k) crc = crc & 1 ? (crc >> 1) ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

using Row = std::vector<double>;

// the homogeneous point at t, in doubles
Row de_boor(int degree, const Row& knots, const std::vector<Row>& rows, double t) {
    int j = degree;
    for (int k = degree; k < int(knots.size()) - degree - 1; ++k)
        if (knots[k] < knots[k + 1] && knots[k] <= t) j = k;
    std::vector<Row> d(rows.begin() + (j - degree), rows.begin() + (j + 1));
    for (int r = 1; r <= degree; ++r)
        for (int i = degree; i >= r; --i) {
            const double a = knots[j - degree + i], b = knots[j + 1 + i - r], s = (t - a) / (b - a);
            for (std::size_t k = 0; k < d[i].size(); ++k) d[i][k] = (1 - s) * d[i - 1][k] + s * d[i][k];
        }
    return d[degree];
}

Row numbers(const Value& list) {
    Row found;
    for (const Value& each : list.list) found.push_back(each.number());
    return found;
}

// the control points times their weights, and the weights
std::vector<Row> homogeneous(const Value& given) {
    const Row weights = numbers(given["weights"]);
    std::vector<Row> rows;
    for (const Value& point : given["points"].list) {
        Row row = numbers(point);
        for (double& x : row) x *= weights[rows.size()];
        row.push_back(weights[rows.size()]);
        rows.push_back(row);
    }
    return rows;
}

int main(int, char** given) {
    std::ifstream stream(given[1]);
    std::map<std::string, long> counts;
    const std::string opening = "{\"digest\":\"";
    for (std::string line; std::getline(stream, line);) {
        if (line.compare(0, opening.size(), opening) != 0) continue;
        const std::string digest = line.substr(opening.size(), 8);
        const std::size_t begin = opening.size() + 8 + std::string("\",\"case\":").size();
        const std::string body = line.substr(begin, line.rfind('}') - begin);
        const Value data = Parser{body.c_str()}.value();
        char computed[9];
        std::snprintf(computed, sizeof computed, "%08x", crc32(body));
        ++counts["cases"];
        counts["damaged"] += digest != computed;
        for (const auto& [name, answer] : data["answers"].fields) ++counts[answer["answer"].text];
        const std::vector<Row> rows = homogeneous(data["doubles"]), partner = homogeneous(data["partner"]["doubles"]);
        const Row knots = numbers(data["doubles"]["knots"]);
        const int degree = int(data["degree"].number());
        const Row point = de_boor(degree, knots, rows, data["parameter"]["double"].number());
        const Value& truth = data["answers"]["value"]["items"].list[0];
        const char* axes[] = {"x", "y", "z"};
        bool right = true;
        for (std::size_t k = 0; k + 1 < point.size(); ++k)
            right = right && point[k] / point.back() == truth[axes[k]].list[1].number();
        counts["inexact"] += !right;
        double size = 0;
        for (const Row& row : rows) for (double x : row) size = std::max(size, std::abs(x));
        // the points that a curve and its partner have in common; apart: that differ by more than 2^-40 of the size
        for (const Value& item : data["answers"]["intersections"].list_of("items")) {
            if (!item.fields.count("parameter")) continue;
            ++counts["meetings"];
            const Row p = de_boor(degree, knots, rows, item["parameter"].list[1].number());
            const Row q = de_boor(degree, knots, partner, item["other parameter"].list[1].number());
            bool apart = false;
            for (std::size_t k = 0; k + 1 < p.size(); ++k)
                apart = apart || std::abs(p[k] / p.back() - q[k] / q.back()) > std::ldexp(size, -40);
            counts["apart"] += apart;
        }
    }
    const char* names[] = {"cases", "damaged", "none", "these", "all", "undefined", "inexact", "meetings", "apart"};
    for (const char* name : names) std::cout << (name == names[0] ? "" : " ") << name << " " << counts[name];
    std::cout << "\n";
}
