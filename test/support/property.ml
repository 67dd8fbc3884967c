let holds ?(count = 500) ?print name gen property =
  QCheck_alcotest.to_alcotest ~speed_level:`Quick
    ~rand:(Random.State.make [| 1987; 2026 |])
    (QCheck2.Test.make ~count ?print ~name gen property)

let show pp = Format.asprintf "%a" pp
