// The bench's findings, as the JSON that it writes, for a text and for gnuplot.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace glint::performance {

// What is asked of Glint: the frame with one lane takes so many times as long as with all, and one
// thread so many times as long as two.
inline constexpr double aim_of_lanes = 8;
inline constexpr double aim_of_threads = 1.85;

// Tables in Markdown. Of bench --against llvmpipe --all-ways:
std::string scenes_table(const nlohmann::json& bench);    // what is drawn
std::string llvmpipe_table(const nlohmann::json& bench);  // both times
std::string work_table(const nlohmann::json& bench);      // beside what the machine can do
std::string accuracy_table(const nlohmann::json& bench);
std::string stages_table(const nlohmann::json& bench);
std::string ways_table(
    const nlohmann::json& bench);  // lanes and threads beside their aims, scanline
// Of bench --scaling:
std::string scaling_table(const nlohmann::json& scaling);
std::string memory_table(const nlohmann::json& scaling);

// A line of names, then a line a scene and number of threads; and a line a point of each scale.
std::string scenes_csv(const nlohmann::json& bench);
std::string scaling_csv(const nlohmann::json& scaling);

}  // namespace glint::performance
