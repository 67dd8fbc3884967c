open Expression
module Bound = Map.Make (String)

let key = String.lowercase_ascii

(* What to do with free names, with the points of patterns, and with places. *)
type change = {
  free : string -> string;
  binder : string -> string;
  own : string -> string; (* any other name that is introduced *)
  place : Raylab_source.Span.t -> Raylab_source.Span.t;
  three : t -> t -> t -> desc;
}

let rec expression change bound { desc; span } =
  { desc = description change bound desc; span = change.place span }

(* [bound] has what became of the names that are introduced around. *)
and name change bound name =
  match Bound.find_opt (key name) bound with
  | Some name -> name
  | None -> change.free name

and introduce become bound name =
  let name' = become name in
  (name', Bound.add (key name) name' bound)

and description change bound desc =
  let go = expression change bound in
  match desc with
  | Number _ | Truth _ | Text _ -> desc
  | Name written -> Name (name change bound written)
  | Call { name = callee; name_span; arguments } ->
      let callee = name change bound callee in
      let arguments = List.map (argument change bound) arguments in
      Call { name = callee; name_span = change.place name_span; arguments }
  | Triple (x, y, z) ->
      let x = go x in
      let y = go y in
      change.three x y (go z)
  | List elements -> List (List.map go elements)
  | Series { name; name_span; range; body } ->
      let range = range_of change bound range in
      let name, inner = introduce change.own bound name in
      let body = expression change inner body in
      Series { name; name_span = change.place name_span; range; body }
  | Part (e, letter) -> Part (go e, letter)
  | Negative e -> Negative (go e)
  | Not e -> Not (go e)
  | Binary (operator, a, b) ->
      let a = go a in
      Binary (operator, a, go b)
  | If (c, a, b) ->
      let c = go c in
      let a = go a in
      If (c, a, go b)
  | Let { name; name_span; value; body } ->
      let value = go value in
      let name, inner = introduce change.own bound name in
      let body = expression change inner body in
      Let { name; name_span = change.place name_span; value; body }
  | Word { word; arguments } ->
      let argument (position, e) = (position, go e) in
      Word { word; arguments = List.map argument arguments }
  | Varying { name; name_span; body } ->
      let name, inner = introduce change.binder bound name in
      let body = expression change inner body in
      Varying { name; name_span = change.place name_span; body }

and argument change bound { label; value } =
  let label =
    Option.map
      (fun (label, span) -> (change.own label, change.place span))
      label
  in
  { label; value = expression change bound value }

and range_of change bound = function
  | In e -> In (expression change bound e)
  | To { first; last; step } ->
      let first = expression change bound first in
      let last = expression change bound last in
      To { first; last; step = Option.map (expression change bound) step }

let triple x y z = Triple (x, y, z)

let kept ~binder ~free =
  { free; binder; own = Fun.id; place = Fun.id; three = triple }

let map ~binder ~free e = expression (kept ~binder ~free) Bound.empty e

(* A default sees the parameters before it. *)
let map_function ~binder ~free parameters body =
  let change = kept ~binder ~free in
  let parameter bound { name; span; default } =
    let default = Option.map (expression change bound) default in
    (Bound.add (key name) name bound, { name; span; default })
  in
  let bound, parameters =
    List.fold_left_map parameter Bound.empty parameters
  in
  (parameters, expression change bound body)

let bound parameters e =
  let found = ref (List.map (fun { name; _ } -> key name) parameters) in
  let introduced name =
    found := key name :: !found;
    name
  in
  let change =
    { (kept ~free:Fun.id ~binder:introduced) with own = introduced }
  in
  ignore (expression change Bound.empty e : t);
  !found

let nowhere = { Raylab_source.Span.start = 0; stop = 0 }

let without_places e =
  let change =
    {
      free = key;
      binder = key;
      own = key;
      place = (fun _ -> nowhere);
      three = (fun x y z -> List [ x; y; z ]);
    }
  in
  expression change Bound.empty e
