open Raylab_tracer
module Sentences = Map.Make (String)

type t = { sees : string; numbers : int list; sample : Explain.sample }

let size group = List.length group.numbers

let of_pixel { Explain.film; samples; _ } =
  let add (number, groups) (sample : Explain.sample) =
    let sees = Reason.sees film sample.ray in
    let join = function
      | None -> Some { sees; numbers = [ number ]; sample }
      | Some group -> Some { group with numbers = number :: group.numbers }
    in
    (number + 1, Sentences.update sees join groups)
  in
  let _, groups = List.fold_left add (1, Sentences.empty) samples in
  let in_order (_, group) = { group with numbers = List.rev group.numbers } in
  let earlier a b = Int.compare (List.hd a.numbers) (List.hd b.numbers) in
  List.map in_order (Sentences.bindings groups)
  |> List.sort earlier
  |> List.stable_sort (fun a b -> Int.compare (size b) (size a))

let rays pixel =
  List.map (fun { sample; _ } -> sample.Explain.ray) (of_pixel pixel)
