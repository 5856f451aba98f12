#include "cli/commands.h"

namespace icebow {
namespace {

const Option set = {"--set", "/KEY=VALUE", "change the study file for this call, like /bow/stem_deg=20",
                    false, true};
const Option design = {
    "--design", "NAME-or-K",
    "a design of the study: its name, or its number as `icebow check` lists it; STUDY may be "
    "a study's directory, which knows an optimiser's designs too"};
const Option json = {"--json", "", "print the result as JSON"};

}  // namespace

// A table. NOLINTNEXTLINE(readability-function-size)
const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      {"new",
       "STUDY",
       "write a first study: five questions, or their answers as options",
       "Asks for length, beam and draught of the ship, thickness of the ice and speed; a question without an "
       "answer takes the value in brackets. The bow it writes is feasible, and so are the bounds of its "
       "angles. Never writes over a file.",
       "icebow new my_ship.json --length 110 --beam 22 --draft 7.5 --thickness 0.8 --speed 3",
       {{"--length", "M", "of the ship between perpendiculars"},
        {"--beam", "M", "of the ship"},
        {"--draft", "M", "of the ship"},
        {"--thickness", "M", "of the level ice"},
        {"--speed", "KN", "of the ship in it"},
        {"--family", "NAME", "of the bow; default: straight_parallel_buttocks (docs/bows.md has eight)"},
        {"--samples", "N", "bows to sweep; default: 60"}},
       false,
       run_new},
      {"check",
       "STUDY",
       "read a study file, list every mistake or what it will do",
       "Lists each mistake with its JSON pointer. Exits with 2 where the file has a mistake, and with 3 "
       "where no design is feasible, or not the one of --design. Nothing is written.",
       "icebow check studies/quickstart.json --set /ice/thickness_m=0.8",
       {set,
        design,
        {"--cost", "",
         "minutes, core hours and disk of the study, or of the design: evaluates the file's own design, or "
         "that one, for some seconds"}},
       false,
       run_check},
      {"hull",
       "STUDY",
       "the hull of a design: angles, feasibility, mesh, lines plan",
       "Exits with 1 where the bow is infeasible, naming the violated inequality. Lengths are full scale.",
       "icebow hull studies/quickstart.json --out bow.stl --hydrostatics",
       {set,
        design,
        {"--out", "FILE",
         "write the mesh (.obj, .stl, .ply, .vtp), the surfaces (.step, .igs) or the lines plan (.svg, "
         ".pdf)"},
        {"--overlay", "OTHER",
         "a second hull in the lines plan: a study file, a family's preset or a design of STUDY"},
        {"--explain", "", "tangent planes, angles as ice class rules name them, and which are near a limit"},
        {"--hydrostatics", "", "displacement, centres, waterplane and sectional areas too"},
        {"--draft", "M", "draft amidships for them; default: the design draught"},
        {"--trim", "DEG", "trim by the stern for them; default: 0"},
        json},
       false,
       run_hull},
      {"measure",
       "MESH",
       "any closed hull mesh: dimensions, angles, hydrostatics",
       "MESH is a mesh (.obj, .stl, .ply), a STEP or IGES file (.step, .igs) or a table of offsets (.csv). "
       "The hull is measured at its waterline; P0 is the stem, P1 at a quarter of the beam. What can be "
       "mended is mended and named; exits with 2 where the mesh stays open, branches or intersects itself.",
       "icebow measure studies/hulls/supply_vessel.obj --draft 6.5",
       {{"--unit", "UNIT", "of the file: m (default), cm, mm, ft, in"},
        {"--axes", "FORWARD,UP", "the file's axes that point forward and up; default: x,z"},
        {"--factor", "F", "lengths are multiplied by this as well: 25 for the mesh of a 1:25 model"},
        {"--left-handed", "", "the file's axes are left-handed: port and starboard change places"},
        {"--waterline", "M", "height of the waterline in metres along that axis; default: 0"},
        {"--draft", "M", "instead: draught to the waterline, from the mesh's lowest point"},
        {"--lower-draft", "M", "draught to the lower ice waterline; default: 0.8 of the draught"},
        {"--mirror", "", "the file has one side of the hull, up to its own centre plane"},
        {"--outer", "", "the file has an open boat with its plating: take its outside, closed by a deck"},
        {"--density", "KG_M3", "of the water; default: 1025"},
        {"--displacement", "T", "find the draught at which the hull displaces this"},
        {"--curves", "FILE",
         "curves of form and righting levers on a page (.svg, .pdf), or the curves as a table (.csv)"},
        {"--kg", "M", "centre of gravity above the keel: --curves draws GZ instead of KN"},
        {"--offsets", "FILE.csv", "write the table of offsets, which `icebow measure` reads too"},
        {"--dxf", "FILE.dxf", "write waterlines, buttocks and stations as lines for CAD programs"},
        json},
       false,
       run_measure},
      {"resistance",
       "STUDY",
       "ice resistance of a design by formulas and by the breaking cycle, full scale",
       "Lindqvist 1989, Riska 1997 and the cycle side by side. Exits with 1 where Lindqvist's formula cannot "
       "be applied.",
       "icebow resistance studies/quickstart.json --set /operation/speed_kn=3",
       {set, design, json},
       false,
       run_resistance},
      {"cycle",
       "STUDY",
       "mean ice load of a design by the breaking cycle, within a second, full scale",
       "The hull's own mesh crushes and breaks level ice over some voyages (section \"cycle\" of the study; "
       "docs/cycle.md). --set /cycle/submersion=false leaves the breaking alone. Exits with 1 where there is "
       "no hull or no voyage.",
       "icebow cycle studies/cycle_sweep.json",
       {set, design, json},
       false,
       run_cycle_command},
      {"calibrate",
       "STUDY",
       "what an ice tank's tests would measure of a design's ice",
       "Bends and crushes pieces of the study's own lattice. With ice.model \"calibrated\" the pieces have "
       "the "
       "file's modulus and flexural strength. Otherwise the modulus and strength follow from the file's "
       "modulus and toughness. Stresses are at the scale of the section \"ice\".",
       "icebow calibrate studies/calibrated_ice.json",
       {set,
        design,
        {"--in-situ", "",
         "beams cut into the floating sheet too: half a minute with 3 layers, minutes with more"},
        {"--cycle", "",
         "instead: press the sheet's edge down over 1, 2, 4, 8 h at three speeds, for the breaking cycle; "
         "minutes, once"},
        json},
       false,
       run_calibrate},
      {"simulate",
       "STUDY",
       "one ship-ice run of one design",
       "Writes DIR/result.json, history.csv, pictures, and ice.pvd, hull.vtp and hull_pressure.pvd for "
       "ParaView (10 "
       "snapshots where the study asks for none). Takes the file's own design where --design names no other. "
       "The same "
       "command again goes on where it was interrupted, on any number of ranks.",
       "mpirun -n 4 icebow simulate studies/calibrated_ice.json --out out/one",
       {set,
        design,
        {"--out", "DIR", "directory of the results", true},
        {"--profile", "", "say at the end where the time of a step went"},
        {"--restart", "", "start anew where DIR holds an interrupted run"},
        json},
       true,
       run_simulate},
      {"run",
       "STUDY",
       "the whole study: evaluate every design, rank, report",
       "An interrupted study goes on when the same command is given again. Finished designs in DIR are kept; "
       "a design that was under way loses the last five minutes at most. At the end the command writes "
       "DIR/report.html, ranking.csv and ranking.md. Exits with 3 where some designs failed or none is "
       "feasible.",
       "icebow run studies/cycle_sweep.json --out out/sweep",
       {set,
        {"--out", "DIR", "directory of the study", true},
        {"--design", "NAME-or-K",
         "this design alone, as the baseline of a study of its own: by all evaluators, in all scenarios"},
        {"--jobs", "N", "designs at once; default: as the study says"},
        {"--retry-failed", "", "evaluate failed designs again, whatever the cause"},
        json},
       true,
       run_run},
      {"rank",
       "DIR",
       "the ranking of a finished or running study",
       "Reads DIR only.",
       "icebow rank out/sweep --json",
       {json},
       false,
       run_rank},
      {"status",
       "DIR",
       "how far a study is, and its best design so far",
       "Reads DIR only, while a run writes too. \"killed\" is a study whose run ended without a word: its "
       "command "
       "goes on with it.",
       "icebow status out/sweep --json",
       {json},
       false,
       run_status},
      {"watch",
       "DIR",
       "the status of a study that another terminal runs, until it ends",
       "Looks again every two seconds. Ends with the study, or by Ctrl-C, which does not touch the study. "
       "Where "
       "the output is no terminal, a status follows the one before where something has changed.",
       "icebow watch out/sweep",
       {{"--once", "", "look once"}, {"--seconds", "S", "between two looks; default 2"}},
       false,
       run_watch},
      {"show",
       "DIR DESIGN",
       "one design of a study: parameters, result, and the commands that take it up again",
       "The command behind \"again\" evaluates the same ship once more, the one behind \"finer\" on a finer "
       "lattice, "
       "by more and finer voyages, or by the cycle instead of the formula.",
       "icebow show out/sweep d012",
       {json},
       false,
       run_show},
      {"export",
       "DIR",
       "all designs of a study with all their numbers, as CSV, JSON or HDF5",
       "CSV has a column for each parameter, each choice of words and each number of a result, JSON the "
       "whole results.",
       "icebow export out/sweep --csv > sweep.csv",
       {{"--csv", "", "print CSV, which is the default"},
        {"--hdf5", "FILE",
         "write HDF5: design, rank, parameters/bow/stem_deg, results/lindqvist/total_N ..., a list each"},
        json},
       false,
       run_export},
      {"diff",
       "DIR OTHER",
       "where two studies differ: what each asks, and the results of the same designs",
       "Designs are the same where they have one name or, as points of a method, the same parameters.",
       "icebow diff out/sweep out/thick_ice",
       {json},
       false,
       run_diff},
      {"effects",
       "DIR",
       "what each parameter of a study does to its load, from the designs that were evaluated",
       "Fits a polynomial to the ranked designs and says how far it errs of a design that is left out. Main "
       "effects and Sobol' indices with 95 % intervals; where the data carry no fit, the reason.",
       "icebow effects out/sweep --json",
       {json},
       false,
       run_effects},
      {"report",
       "DIR",
       "the report of a finished or running study",
       "One HTML file that opens offline.",
       "icebow report out/sweep --out sweep.html",
       {{"--out", "FILE", "default: DIR/report.html"}},
       false,
       run_report},
      {"picture",
       "DIR",
       "the ice breaking, animated, from the pictures of a simulated design",
       "Makes an animated PNG of DIR/ice_000.png and so on, as many as output.pictures of the study asks "
       "for. "
       "Browsers play it; `simulate` and `run` write one for each design with two pictures or more.",
       "icebow picture out/one --seconds 0.2",
       {{"--out", "FILE.png", "default: DIR/breaking.png"},
        {"--seconds", "S", "of each picture; default: five seconds of all, a second each at most"}},
       false,
       run_picture},
  };
  return all;
}

}  // namespace icebow
