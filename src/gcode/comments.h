// What slicers say in comments about the moves that follow: the feature, the layer, the bead, and
// who speaks for what firmware. Understood are the tags of PrusaSlicer and its kin (;TYPE:
// ;LAYER_CHANGE ;Z: ;HEIGHT: ;WIDTH:), of Bambu Studio (; FEATURE: and so on), of Cura and
// ideaMaker
// (;TYPE: ;LAYER:) and of Simplify3D (; feature …, ; layer 1, Z = …).
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "toolpath/command.h"

namespace bead {

// The role that a slicer means by the word, `other` if it is not known.
Role role_called(std::string_view word);
// The word by which PrusaSlicer calls the role; of travel: "".
std::string_view prusa_word(Role role);

class Annotations {
  public:
    // `comment` is a whole line's text after its ';'.
    void note(std::string_view comment);

    [[nodiscard]] Role role() const { return role_; }
    [[nodiscard]] Bead bead() const { return bead_; }
    [[nodiscard]] const std::string& slicer() const { return slicer_; }
    // A layer is announced of which nothing is printed yet.
    [[nodiscard]] bool announces_layer() const { return pending_.has_value(); }
    [[nodiscard]] bool for_reprap() const { return for_reprap_; }  // RepRapFirmware's dialect

    // The layer that begins with the next command, once, if the comments have said its height.
    std::optional<LayerStart> layer_due() {
        if (!pending_ || !pending_->z) return {};
        return begun(*pending_->z);
    }
    // The layer that begins with a bead between these heights (mm), once: one whose own height
    // the comments leave open or, as long as nobody has named feature or layer, each new height of
    // a level bead.
    std::optional<LayerStart> layer_due(double from_z, double to_z) {
        if (tagged_ && !pending_) return {};
        return layer_of_bead(from_z, to_z);
    }

  private:
    struct Tag;
    struct Pending {
        std::optional<double> z, height;
    };
    LayerStart begun(double z);
    std::optional<LayerStart> layer_of_bead(double from_z, double to_z);
    void type(std::string_view word);
    void layer_change(std::string_view);
    void layer_number(std::string_view);
    void layer_z(std::string_view number);
    void height(std::string_view number);
    void width(std::string_view number);
    void author(std::string_view name);
    void bambu(std::string_view);
    void flavor(std::string_view name);
    void simplify(std::string_view text);

    Role role_ = Role::other;
    Bead bead_;
    std::string slicer_;
    std::optional<Pending> pending_;
    std::optional<double> inferred_z_;
    bool tagged_ = false;  // features or layers are named: nothing is to be inferred
    bool for_reprap_ = false;
    bool names_changes_ = false;  // by LAYER_CHANGE; then LAYER: is somebody's own remark
};

}  // namespace bead
