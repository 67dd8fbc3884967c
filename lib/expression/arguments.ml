type 'a t = (Expression.argument * 'a) list

let make arguments = arguments

let usage name parameters =
  let one { Value.label; optional } =
    if optional then label ^ ": ..." else label
  in
  Printf.sprintf "%s(%s)" name
    (String.concat ", " (List.map one (Array.to_list parameters)))

let same a b = String.lowercase_ascii a = String.lowercase_ascii b

let index_of parameters label =
  let is_it { Value.label = other; _ } = same label other in
  Array.find_index is_it parameters

let arrange span ~name parameters arguments =
  let advice = "it is written " ^ usage name parameters in
  let arranged = Array.make (Array.length parameters) None in
  let put place at argument =
    if Option.is_some arranged.(place) then
      Fault.fail at ~advice
        (Printf.sprintf "%s gets %s twice" name parameters.(place).label);
    arranged.(place) <- Some argument
  in
  let next = ref 0 in
  List.iter
    (fun ((written : Expression.argument), argument) ->
      match written.label with
      | None when !next < Array.length parameters ->
          put !next written.value.span argument;
          incr next
      | None ->
          Fault.fail written.value.span ~advice
            (Printf.sprintf "%s takes %d argument%s, not %d" name
               (Array.length parameters)
               (if Array.length parameters = 1 then "" else "s")
               (List.length arguments))
      | Some (label, at) -> (
          match index_of parameters label with
          | Some place -> put place at argument
          | None ->
              Fault.fail at ~advice
                (Printf.sprintf "%s has no parameter %s" name label)))
    arguments;
  Array.iteri
    (fun k { Value.label; optional } ->
      if Option.is_none arranged.(k) && not optional then
        Fault.fail span ~advice (Printf.sprintf "%s lacks %s" name label))
    parameters;
  arranged
