type look = { color : x:int -> y:int -> int; step : x:int -> y:int -> int }

(* in a row and in a column *)
let most_samples = 4

(* [spread (first, last)] is at most [most_samples] numbers from [first] to
   [last], evenly spread. *)
let spread (first, last) =
  let count = last - first + 1 in
  let n = Int.min count most_samples in
  Array.init n (fun k -> first + (((2 * k) + 1) * count / (2 * n)))

let dim { color; step } =
  let dark color shift = ((color lsr shift) land 255 * 3 / 10) lsl shift in
  let color ~x ~y =
    let color = color ~x ~y in
    dark color 16 lor dark color 8 lor dark color 0
  in
  { color; step }

(* {1 The window} *)

type t = {
  layout : Layout.t;
  columns : int array array;
      (** of the picture, for each column of the window *)
  colors : int array array;  (** beside the picture they stay what they are *)
}

let make layout ~background =
  let { Box.width; height; _ } = Layout.window layout
  and shown = Layout.shown layout in
  let column x =
    let u = x - shown.left in
    if u < 0 || u >= shown.width then [||]
    else spread (Layout.columns layout u)
  in
  {
    layout;
    columns = Array.init width column;
    colors = Array.init height (fun _ -> Array.make width background);
  }

(* {1 Its colours}

   Nothing is allocated for a pixel: a collection stops all domains that
   render. *)

let part sum n = ((2 * sum) + n) / (2 * n)

let mean color xs ys =
  let red = ref 0 and green = ref 0 and blue = ref 0 in
  for j = 0 to Array.length ys - 1 do
    for i = 0 to Array.length xs - 1 do
      let c = color ~x:xs.(i) ~y:ys.(j) in
      red := !red + (c lsr 16);
      green := !green + ((c lsr 8) land 255);
      blue := !blue + (c land 255)
    done
  done;
  let n = Array.length xs * Array.length ys in
  (part !red n lsl 16) lor (part !green n lsl 8) lor part !blue n

let middle some = some.(Array.length some / 2)

(* Most pixels of a coarse picture, or a magnified one, are in the block of the
   pixel before. *)
let fill row { color; step } columns ys =
  let y = middle ys in
  let block_end = ref 0 and block_color = ref 0 in
  for i = 0 to Array.length row - 1 do
    let xs = columns.(i) in
    if Array.length xs > 0 then (
      let x = middle xs in
      if x >= !block_end then (
        let step = step ~x ~y in
        block_end := (x land -step) + step;
        let is_one = Array.length xs = 1 && Array.length ys = 1 in
        block_color :=
          if is_one || step <> 1 then color ~x ~y else mean color xs ys);
      row.(i) <- !block_color)
  done

let rows { layout; columns; colors } look ~top ~height =
  let shown = Layout.shown layout in
  let middle = Box.inter shown { shown with top; height } in
  for y = middle.top to middle.top + middle.height - 1 do
    let ys = spread (Layout.rows layout (y - shown.top)) in
    fill colors.(y) look columns ys
  done;
  Array.sub colors top height
