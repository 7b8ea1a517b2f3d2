// A command to the member function that obeys it: what every planner does alike. A planner has
// move(Move, line), arc(Arc, line), set_position, home, drain, pass(event) and change(SetLimits).
#pragma once
#include "motion/block.h"

namespace bead {

template <class P>
struct Obey {
    P& planner;
    std::int64_t line;

    void operator()(const Move& move) const { planner.move(move, line); }
    void operator()(const Arc& arc) const { planner.arc(arc, line); }
    void operator()(const SetPosition& position) const { planner.set_position(position); }
    void operator()(const Home& home) const {
        planner.drain();
        planner.home(home);
    }
    void operator()(const Dwell& dwell) const {
        planner.drain();
        planner.pass(dwell);
    }
    void operator()(const Drain&) const { planner.drain(); }
    void operator()(const SetHeat& heat) const {
        if (heat.wait) planner.drain();
        planner.pass(heat);
    }
    void operator()(const SetFan& fan) const { planner.pass(fan); }
    void operator()(const LayerStart& layer) const { planner.pass(layer); }
    void operator()(const SetLimits& limits) const { planner.change(limits); }
};

template <class P>
void obey(P& planner, const Command& command) {
    if (const Move* const move = std::get_if<Move>(&command.what))
        planner.move(*move, command.line);
    else
        std::visit(Obey<P>{planner, command.line}, command.what);
}

}  // namespace bead
