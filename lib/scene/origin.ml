open Raylab_expression

type t =
  | Unknown
  | Literal of int
  | Made of { at : int; within : Trail.t }
  | Placed of { at : int; within : Trail.t; placed : placed }

and placed =
  | At_once
  | By_name of { name : string; at : int; within : Trail.t; around : placed }

let offset = function
  | Unknown -> None
  | Literal at | Made { at; _ } | Placed { at; _ } -> Some at

let make ~at ~within =
  match within with Trail.Start -> Literal at | within -> Made { at; within }

let again within = function
  | Literal at -> make ~at ~within
  | (Unknown | Made _ | Placed _) as origin -> origin

let place placed origin =
  match (origin, placed) with
  | (Unknown | Placed _), _ | _, At_once -> origin
  | Literal at, _ -> Placed { at; within = Start; placed }
  | Made { at; within }, _ -> Placed { at; within; placed }
