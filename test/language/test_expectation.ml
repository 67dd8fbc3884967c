(* Every state in which the parser can stop has something to say. *)

open Raylab_language

(* Where all is read there is nothing to expect: such a state reduces, whatever
   comes, and the parser stops in no such state. Where a name is read that may
   be the label of an argument, too, it goes on with the operator. *)
let can_stop items =
  List.exists (fun { Parser_state.after; _ } -> after <> []) items

let says_something = function
  | Some { Expectation.noun; advice } ->
      noun <> ""
      && String.length advice > 20
      && String.ends_with ~suffix:"." advice
  | None -> false

let show items =
  String.concat " | "
    (List.map
       (fun { Parser_state.whole; before; after } ->
         Printf.sprintf "%s: %s . %s" whole (String.concat " " before)
           (String.concat " " after))
       items)

let test_all () =
  let is_silent items =
    can_stop items && not (says_something (Expectation.of_items items))
  in
  Alcotest.(check (list string))
    "states that say nothing" []
    (List.map show (List.filter is_silent (Array.to_list Parser_state.items)))

let suite =
  ("Expectation", [ Alcotest.test_case "every state" `Quick test_all ])
