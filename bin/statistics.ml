open Raylab_tracer

let print (tally : Tally.t) picture ~seconds =
  let pixels = Picture.width picture * Picture.height picture in
  let rays = Tally.rays tally in
  let per_pixel n = float_of_int n /. float_of_int pixels in
  let count name n = Command.line "%-15s %12d" name n in
  count "primary rays" tally.primary;
  count "reflected rays" tally.reflected;
  if tally.refracted > 0 then count "refracted rays" tally.refracted;
  count "shadow rays" tally.shadow;
  count "rays" rays;
  count "hits" tally.hits;
  count "lights blocked" tally.blocked;
  count "pixels" pixels;
  Command.line "%-15s %12.3f" "samples a pixel" (per_pixel tally.samples);
  Command.line "%-15s %12.2f %%" "over-exposed"
    (100. *. per_pixel tally.over_exposed);
  Command.line "%-15s %12.3f s" "time" seconds;
  Command.line "%-15s %12.0f" "rays per second" (float_of_int rays /. seconds)
