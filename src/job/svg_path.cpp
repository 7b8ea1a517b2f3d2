#include "job/svg_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "geom/cubic_spline.h"
#include "job/one_line.h"

namespace bead {
namespace {

constexpr int curve_pieces = 48;

[[noreturn]] void refuse(const std::string& name, std::string_view text) {
    throw Error(fmt::format("{}: cannot read \"{}\"; save it as plain SVG", name, one_line(text)));
}

// Numbers, letters and flags one after another; "1-2.5.5" is three numbers.
class Scanner {
  public:
    Scanner(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    bool at_end() {
        skip();
        return text_.empty();
    }
    std::optional<char> letter() {
        skip();
        if (text_.empty() || std::isalpha(static_cast<unsigned char>(text_[0])) == 0)
            return std::nullopt;
        const char found = text_[0];
        text_.remove_prefix(1);
        return found;
    }
    double number() {
        skip();
        if (!text_.empty() && text_[0] == '+') text_.remove_prefix(1);
        double value = 0;
        const auto [end, fault] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
        if (fault != std::errc{} || !std::isfinite(value)) refuse(name_, text_);
        text_.remove_prefix(std::size_t(end - text_.data()));
        return value;
    }
    bool flag() {
        skip();
        if (text_.empty() || (text_[0] != '0' && text_[0] != '1')) refuse(name_, text_);
        const bool value = text_[0] == '1';
        text_.remove_prefix(1);
        return value;
    }

  private:
    void skip() {
        while (!text_.empty() &&
               (std::isspace(static_cast<unsigned char>(text_[0])) != 0 || text_[0] == ','))
            text_.remove_prefix(1);
    }
    std::string_view text_;
    const std::string& name_;
};

// By centre and angles, as the SVG standard's appendix on arcs derives them.
void append_arc(Polyline& line, Vec2 to, Vec2 radii, double turn, bool large, bool sweep) {
    const Vec2 from = line.back();
    const Vec2 back = unit(-turn);
    const Vec2 half = rotated(0.5 * (from - to), back);
    radii = {std::abs(radii.x), std::abs(radii.y)};
    if (radii.x == 0 || radii.y == 0 || from == to) {
        line.push_back(to);
        return;
    }
    const double over = std::hypot(half.x / radii.x, half.y / radii.y);
    if (over > 1) radii = over * radii;
    const double k = std::sqrt(std::max(0.0, 1 / (std::min(over, 1.0) * std::min(over, 1.0)) - 1)) *
                     (large == sweep ? -1 : 1);
    const Vec2 centre{k * radii.x * half.y / radii.y, -k * radii.y * half.x / radii.x};
    const auto angle = [&](Vec2 p) {
        return std::atan2((p.y - centre.y) / radii.y, (p.x - centre.x) / radii.x);
    };
    const double begin = angle(half);
    double sweep_angle = angle(-half) - begin;
    if (sweep && sweep_angle < 0) sweep_angle += 2 * pi;
    if (!sweep && sweep_angle > 0) sweep_angle -= 2 * pi;
    const Vec2 middle = 0.5 * (from + to), forth = unit(turn);
    for (int i = 1; i < curve_pieces; ++i) {
        const Vec2 u = unit(begin + sweep_angle * i / curve_pieces);
        line.push_back(middle + rotated(centre + Vec2{radii.x * u.x, radii.y * u.y}, forth));
    }
    line.push_back(to);
}

void append_cubic(Polyline& line, Vec2 p1, Vec2 p2, Vec2 p3) {
    const Cubic cubic{line.back(), p1, p2, p3};
    for (int i = 1; i <= curve_pieces; ++i)
        line.push_back(point_at(cubic, double(i) / curve_pieces));
}

class PathReader {
  public:
    PathReader(std::string_view d, const std::string& name) : scan_(d, name), name_(name) {}

    std::vector<Polyline> read() {
        char command = 0;
        while (!scan_.at_end()) {
            if (const auto letter = scan_.letter())
                command = *letter;
            else if (command == 0 || command == 'Z' || command == 'z')
                refuse(name_, "a path without command");
            obey(command);
            // More pairs after a move are lines.
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
        finish();
        return std::move(loops_);
    }

  private:
    Vec2 point(bool relative) {
        const double x = scan_.number(), y = scan_.number();
        return relative ? here_ + Vec2{x, y} : Vec2{x, y};
    }
    void finish() {
        if (line_.size() > 1 && distance(line_.front(), line_.back()) < 1e-9) line_.pop_back();
        if (line_.size() > 2) loops_.push_back(line_);
        line_.clear();
    }
    void start() {
        if (line_.empty()) line_.push_back(here_);
    }
    void move_to(Vec2 p) {
        finish();
        here_ = begin_ = p;
    }
    void curve(char kind, bool relative) {
        Vec2 first{};
        if (kind == 'C') first = point(relative);
        if (kind == 'S') first = last_kind_ == 'C' ? 2 * here_ - control_ : here_;
        if (kind == 'Q') control_ = point(relative);
        if (kind == 'T') control_ = last_kind_ == 'Q' ? 2 * here_ - control_ : here_;
        const bool cubic = kind == 'C' || kind == 'S';
        if (cubic) control_ = point(relative);
        const Vec2 to = point(relative);
        if (cubic)
            append_cubic(line_, first, control_, to);
        else
            append_cubic(line_, lerp(here_, control_, 2.0 / 3), lerp(to, control_, 2.0 / 3), to);
        here_ = to;
        last_kind_ = cubic ? 'C' : 'Q';
    }
    void arc(bool relative) {
        const double rx = scan_.number(), ry = scan_.number(), turn = scan_.number() * pi / 180;
        const bool large = scan_.flag(), sweep = scan_.flag();
        here_ = point(relative);
        append_arc(line_, here_, {rx, ry}, turn, large, sweep);
    }
    void straight(char kind, bool relative) {
        if (kind == 'L') here_ = point(relative);
        if (kind == 'H') here_.x = scan_.number() + (relative ? here_.x : 0);
        if (kind == 'V') here_.y = scan_.number() + (relative ? here_.y : 0);
        line_.push_back(here_);
    }
    void obey(char command) {
        const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
        const char kind = char(std::toupper(static_cast<unsigned char>(command)));
        if (kind == 'M') return move_to(point(relative));
        if (kind == 'Z') {
            finish();
            here_ = begin_;
            return;
        }
        start();
        if (std::string_view("CSQT").find(kind) != std::string_view::npos)
            return curve(kind, relative);
        last_kind_ = 0;
        if (kind == 'A') return arc(relative);
        if (std::string_view("LHV").find(kind) == std::string_view::npos)
            refuse(name_, std::string(1, command));
        straight(kind, relative);
    }

    Scanner scan_;
    const std::string& name_;
    std::vector<Polyline> loops_;
    Polyline line_;
    Vec2 here_, begin_, control_;
    char last_kind_ = 0;  // of curve, for the smooth ones
};

SvgTransform transform_of(std::string_view kind, const std::vector<double>& n,
                          const std::string& name) {
    const auto at = [&](std::size_t i, double fallback) { return i < n.size() ? n[i] : fallback; };
    if (kind == "matrix" && n.size() == 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
    if (kind == "translate" && !n.empty()) return {1, 0, 0, 1, n[0], at(1, 0)};
    if (kind == "scale" && !n.empty()) return {n[0], 0, 0, at(1, n[0]), 0, 0};
    if (kind == "rotate" && !n.empty()) {
        const Vec2 u = unit(n[0] * pi / 180), about{at(1, 0), at(2, 0)};
        const Vec2 shift = about - rotated(about, u);
        return {u.x, u.y, -u.y, u.x, shift.x, shift.y};
    }
    if (kind == "skewX" && !n.empty()) return {1, 0, std::tan(n[0] * pi / 180), 1, 0, 0};
    if (kind == "skewY" && !n.empty()) return {1, std::tan(n[0] * pi / 180), 0, 1, 0, 0};
    refuse(name, kind);
}

}  // namespace

SvgTransform operator*(const SvgTransform& o, const SvgTransform& i) {
    return {o.a * i.a + o.c * i.b, o.b * i.a + o.d * i.b,       o.a * i.c + o.c * i.d,
            o.b * i.c + o.d * i.d, o.a * i.e + o.c * i.f + o.e, o.b * i.e + o.d * i.f + o.f};
}

std::vector<double> svg_numbers(std::string_view text, const std::string& name) {
    Scanner scan(text, name);
    std::vector<double> numbers;
    while (!scan.at_end()) numbers.push_back(scan.number());
    return numbers;
}

Polyline svg_points(std::string_view text, const std::string& name) {
    const std::vector<double> numbers = svg_numbers(text, name);
    Polyline line;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
        line.push_back({numbers[i], numbers[i + 1]});
    return line;
}

SvgTransform svg_transform(std::string_view text, const std::string& name) {
    SvgTransform result;
    while (!(text = trimmed(text)).empty()) {
        const std::size_t open = text.find('('), close = text.find(')');
        if (open == text.npos || close == text.npos || close < open) refuse(name, text);
        std::string_view kind = trimmed(text.substr(0, open));
        while (!kind.empty() && kind[0] == ',') kind = trimmed(kind.substr(1));
        result =
            result *
            transform_of(kind, svg_numbers(text.substr(open + 1, close - open - 1), name), name);
        text.remove_prefix(close + 1);
    }
    return result;
}

std::vector<Polyline> svg_path(std::string_view d, const std::string& name) {
    return PathReader(d, name).read();
}

}  // namespace bead
