open Raylab_source
module Names = Map.Make (String)

type binding = {
  level : int;
  slot : int;
  span : Span.t;
  mutable is_defined : bool;
}

type room = { mutable size : int }
type report = Span.t -> advice:string -> string -> unit

type t = {
  names : binding Names.t;
  level : int;
  room : room;
  report : report;
  hint : string -> string option;
  told : (string, unit) Hashtbl.t;
}

let start ?(hint = fun _ -> None) report =
  {
    names = Names.empty;
    level = 0;
    room = { size = 0 };
    report;
    hint;
    told = Hashtbl.create 17;
  }

let key = String.lowercase_ascii

let add scope name binding =
  { scope with names = Names.add (key name) binding scope.names }

let bind scope ?(is_defined = true) name span =
  let slot = scope.room.size in
  scope.room.size <- slot + 1;
  let binding = { level = scope.level; slot; span; is_defined } in
  (add scope name binding, binding)

let enter scope = { scope with level = scope.level + 1; room = { size = 0 } }
let size scope = scope.room.size
let level scope = scope.level
let find scope name = Names.find_opt (key name) scope.names
let names scope = List.map fst (Names.bindings scope.names)
let report scope = scope.report
let hint scope name = scope.hint name

let report_once scope name span ~advice message =
  if not (Hashtbl.mem scope.told (key name)) then (
    Hashtbl.add scope.told (key name) ();
    scope.report span ~advice message)
