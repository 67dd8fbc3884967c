(* in a row and in a column *)
let most_samples = 4

(* [spread (first, last)] is at most [most_samples] numbers from [first] to
   [last], evenly spread. *)
let spread (first, last) =
  let count = last - first + 1 in
  let n = Int.min count most_samples in
  Array.init n (fun k -> first + (((2 * k) + 1) * count / (2 * n)))

let mean color xs ys =
  let red = ref 0 and green = ref 0 and blue = ref 0 in
  Array.iter
    (fun y ->
      Array.iter
        (fun x ->
          let c = color ~x ~y in
          red := !red + (c lsr 16);
          green := !green + ((c lsr 8) land 255);
          blue := !blue + (c land 255))
        xs)
    ys;
  let n = Array.length xs * Array.length ys in
  let part sum = ((2 * sum) + n) / (2 * n) in
  (part !red lsl 16) lor (part !green lsl 8) lor part !blue

let colors layout color ~background (box : Box.t) =
  let shown = Layout.shown layout in
  let columns =
    Array.init box.width (fun i ->
        let u = box.left + i - shown.left in
        if u < 0 || u >= shown.width then [||]
        else spread (Layout.columns layout u))
  in
  Array.init box.height (fun j ->
      let v = box.top + j - shown.top in
      if v < 0 || v >= shown.height then Array.make box.width background
      else
        let ys = spread (Layout.rows layout v) in
        Array.map
          (fun xs ->
            match (xs, ys) with
            | [||], _ -> background
            | [| x |], [| y |] -> color ~x ~y
            | _ -> mean color xs ys)
          columns)

let dim color =
  let part shift = ((color lsr shift) land 255 * 3 / 10) lsl shift in
  part 16 lor part 8 lor part 0
