(** Properties: qcheck tests with a fixed seed. *)

val holds :
  ?count:int ->
  ?print:'a QCheck2.Print.t ->
  string ->
  'a QCheck2.Gen.t ->
  ('a -> bool) ->
  unit Alcotest.test_case
(** [holds name gen property] is the test that [property] is true of [count]
    values, 500 by default, of [gen]. Every run takes the same values. In
    JavaScript a tenth of them has to do. *)

val show : (Format.formatter -> 'a -> unit) -> 'a QCheck2.Print.t
(** [show pp] is what [pp] prints, for [print]. *)
