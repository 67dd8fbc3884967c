open Raylab_geometry.Unchecked

let emission = 0
let albedo = 3
let mirror = 6
let size = 9

(* {1 All lobes of a surface} *)

type t = {
  mutable core : float array;
  mutable opened : int array;
  highlights : Raw_parts.t;
  refractions : Raw_parts.t;
}

let plain = 1
let fresnel = 4
let glass = 7

let create () =
  {
    core = Array.make size 0.;
    opened = [| 0; 0 |];
    highlights = Raw_parts.create ~colors:1;
    refractions = Raw_parts.create ~colors:3;
  }

let is_plain { highlights; refractions; _ } =
  highlights.count = 0 && refractions.count = 0

let color numbers at =
  Color.make numbers.(at) numbers.(at + 1) numbers.(at + 2)

let read { core; highlights; refractions; _ } =
  let read { Raw_parts.numbers; size; count } part =
    List.init count (fun k -> part numbers (k * size))
  in
  {
    Lobes.emission = color core emission;
    albedo = color core albedo;
    mirror = color core mirror;
    highlights =
      read highlights (fun numbers at ->
          { Lobes.sharpness = numbers.(at); shine = color numbers (at + 1) });
    refractions =
      read refractions (fun numbers at ->
          {
            Lobes.index = numbers.(at);
            plain = color numbers (at + plain);
            fresnel = color numbers (at + fresnel);
            glass = color numbers (at + glass);
          });
  }

(* {1 Writing} *)

let clear { highlights; refractions; _ } =
  Raw_parts.clear highlights;
  Raw_parts.clear refractions

(* Twice as many rows as there were. *)
let grow raw =
  raw.core <- Array.append raw.core raw.core;
  raw.opened <- Array.append raw.opened raw.opened

let open_row raw row =
  if 2 * row >= Array.length raw.opened then grow raw;
  Array.fill raw.core (row * size) size 0.;
  raw.opened.(2 * row) <- raw.highlights.count;
  raw.opened.((2 * row) + 1) <- raw.refractions.count

let set raw row lobe ({ r; g; b } : Color.t) =
  let at = (row * size) + lobe in
  raw.core.(at) <- r;
  raw.core.(at + 1) <- g;
  raw.core.(at + 2) <- b

let add_highlight { highlights; _ } ~sharpness color =
  let at = Raw_parts.add highlights sharpness in
  Raw_parts.set highlights (at + 1) color

let add_refractive { refractions; _ } ~index color =
  let at = Raw_parts.add refractions index in
  Raw_parts.set refractions (at + plain) color

let add_glass { refractions; _ } ~index color =
  let at = Raw_parts.add refractions index in
  Raw_parts.set refractions (at + fresnel) Color.white;
  Raw_parts.set refractions (at + glass) color

let[@inline] add core at weight =
  core.(at) <- Saturate.limit (core.%(at) +. (weight *. core.(at + size)))

let mix_cores core row ({ r; g; b } : Color.t) =
  for lobe = 0 to 2 do
    let at = (row * size) + (3 * lobe) in
    add core at r;
    add core (at + 1) g;
    add core (at + 2) b
  done

(* [opened.(at)] is how many [parts] there were when the mix was opened. *)
let mix_parts (parts : Raw_parts.t) opened at weight =
  if parts.count > opened.(at + 2) then
    Raw_parts.mix parts ~first:opened.(at) ~from:opened.(at + 2) weight

let mix { core; opened; highlights; refractions } row weight =
  mix_cores core row weight;
  mix_parts highlights opened (2 * row) weight;
  mix_parts refractions opened ((2 * row) + 1) weight
