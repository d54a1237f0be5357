// Reads a pack of vectors: g++ -O2 -std=c++17 -ffp-contract=off reader.cpp -o reader && ./reader near.json
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
        const Row weights = numbers(data["doubles"]["weights"]);
        std::vector<Row> rows;
        for (const Value& point : data["doubles"]["points"].list) {
            Row row = numbers(point);
            for (double& x : row) x *= weights[rows.size()];
            row.push_back(weights[rows.size()]);
            rows.push_back(row);
        }
        const int degree = int(data["degree"].number());
        const Row point = de_boor(degree, numbers(data["doubles"]["knots"]), rows, data["parameter"]["double"].number());
        const Value& truth = data["answers"]["value"]["items"].list[0];
        const char* axes[] = {"x", "y", "z"};
        bool right = true;
        for (std::size_t k = 0; k + 1 < point.size(); ++k)
            right = right && point[k] / point.back() == truth[axes[k]].list[1].number();
        counts["inexact"] += !right;
    }
    const char* names[] = {"cases", "damaged", "none", "these", "all", "undefined", "inexact"};
    for (const char* name : names) std::cout << (name == names[0] ? "" : " ") << name << " " << counts[name];
    std::cout << "\n";
}
