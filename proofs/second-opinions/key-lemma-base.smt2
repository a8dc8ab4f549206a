; Uniqueness of the embedded path, base: at v0 the direction of the marker tells all
; Says: Two darts at the marked vertex with the same bearing (the number of places from the dart
;   to the one pointed at) are the same dart.
; Paper: V, step 2 ('the marker direction information ... disambiguates')
; Symbols:
;   Dart          the darts of the map S (the lemma holds in the world as well)
;   Turn          numbers of places to turn by
;   turn, unturn  (turn b x) = sigma^b(x); its inverse for each b (turns-reversible)
;   home          the dart lies at the marked vertex v0
;   bearing       the offset to the pointed dart, as sensed at v0
;   pointed       the dart that the marker points to
;   x, y          two darts where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort Turn 0)
(declare-fun turn (Turn Dart) Dart)
(declare-fun unturn (Turn Dart) Dart)
(declare-fun home (Dart) Bool)
(declare-fun bearing (Dart) Turn)
(declare-const pointed Dart)
(declare-const x Dart)
(declare-const y Dart)

; turning is reversible
(assert (forall ((b Turn) (d Dart)) (= (unturn b (turn b d)) d)))
; what a bearing is
(assert (forall ((d Dart)) (=> (home d) (= (turn (bearing d) d) pointed))))
; the empty sequence of motions ends at v0 for both
(assert (home x))
(assert (home y))
; and the percepts are equal, direction included
(assert (= (bearing x) (bearing y)))

; not: the same dart
(assert (not (= x y)))
(check-sat)
