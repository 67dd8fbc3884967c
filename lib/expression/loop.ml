type 'thing range =
  | To of {
      first : 'thing Frame.t -> float;
      last : 'thing Frame.t -> float;
      step : 'thing Frame.t -> float;
      step_of : Expression.t;
    }
  | In of { list : 'thing Frame.t -> 'thing Value.t; written : Expression.t }

let each ~at range (frame : _ Frame.t) f =
  let round value =
    Budget.step frame.run.budget at;
    f value
  in
  match range with
  | In { list; written } ->
      Array.iter round (Operation.elements frame.run written (list frame))
  | To { first; last; step; step_of } ->
      let first = first frame in
      let last = last frame in
      let step = step frame in
      let count = Rounds.count ~step_of ~first ~last ~step in
      let k = ref 0. in
      while !k < count do
        round (Value.Number (Rounds.value ~first ~step !k));
        k := !k +. 1.
      done
