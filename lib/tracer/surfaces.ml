open Raylab_geometry
open Raylab_scene

type t = {
  lobes : float array;
  rows : int array;
  primitive_rows : int array array;
  rich : Raw_lobes.t array;
  patterned : Surface.ready array;
}

let varies = -1
let of_primitives = -2
let first_rich = -3
let first_patterned = -1_000_000_000
let rich t row = t.rich.(first_rich - row)
let is_patterned row = row <= first_patterned
let pattern row = first_patterned - row

(* The surfaces of either kind that have a row, the last one first. *)
type listed = {
  mutable plain : Surface.t list;
  mutable plain_count : int;
  mutable others : Surface.t list;
  mutable other_count : int;
  mutable patterned : Surface.t list;
  mutable patterned_count : int;
}

let new_row listed surface =
  if Surface.has_patterns surface then (
    let row = first_patterned - listed.patterned_count in
    listed.patterned <- surface :: listed.patterned;
    listed.patterned_count <- listed.patterned_count + 1;
    row)
  else if Surface.varies surface then varies
  else if Surface.is_plain surface then (
    let row = listed.plain_count * Raw_lobes.size in
    listed.plain <- surface :: listed.plain;
    listed.plain_count <- listed.plain_count + 1;
    row)
  else
    let row = first_rich - listed.other_count in
    listed.others <- surface :: listed.others;
    listed.other_count <- listed.other_count + 1;
    row

(* Surfaces that are one, one after another, share a row. *)
let rows_of listed objects =
  let last = ref None in
  let row (o : Object.t) =
    match !last with
    | Some (surface, row) when surface == o.surface -> row
    | _ ->
        let row = new_row listed o.surface in
        last := Some (o.surface, row);
        row
  in
  let object_ (o : Object.t) =
    match o.primitives with
    | [||] -> (row o, [||])
    | primitives -> (of_primitives, Array.map row primitives)
  in
  Array.map object_ objects

let nowhere = Spot.create
let no = Surface.no_machines

let write_plain { plain; plain_count; _ } =
  let lobes = Array.make (plain_count * Raw_lobes.size) 0.
  and raw = Raw_lobes.create ()
  and spot = nowhere () in
  let write k surface =
    let at = (plain_count - 1 - k) * Raw_lobes.size in
    Surface.write no surface spot raw;
    Array.blit raw.core 0 lobes at Raw_lobes.size
  in
  List.iteri write plain;
  lobes

let write_other surface =
  let raw = Raw_lobes.create () in
  Surface.write no surface (nowhere ()) raw;
  raw

let make objects =
  let listed =
    {
      plain = [];
      plain_count = 0;
      others = [];
      other_count = 0;
      patterned = [];
      patterned_count = 0;
    }
  in
  let all = rows_of listed objects in
  {
    lobes = write_plain listed;
    rows = Array.map fst all;
    primitive_rows =
      (if Array.exists (fun (row, _) -> row = of_primitives) all then
         Array.map snd all
       else [||]);
    rich = Array.of_list (List.rev_map write_other listed.others);
    patterned = Array.of_list (List.rev_map Surface.ready listed.patterned);
  }
