(* JavaScript takes several times as long, and it is there for what is different
   about its numbers, not for rare cases. *)
let share count = if Javascript.here then (count + 9) / 10 else count

let holds ?(count = 500) ?print name gen property =
  QCheck_alcotest.to_alcotest ~speed_level:`Quick
    ~rand:(Random.State.make [| 1987; 2026 |])
    (QCheck2.Test.make ~count:(share count) ?print ~name gen property)

let show pp = Format.asprintf "%a" pp
