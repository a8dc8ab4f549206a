; A test that matches to the end proves its hypothesis, base: no motions left
; Says: The hypothesis h lies at v0 and the robot, in x, senses the marker with the bearing that
;   is expected for h: then the robot is in the dart that h stands for.
; Paper: IV, case (3); V, step 2
; Symbols:
;   Dart, MapDart  the darts of the world G; the darts of the map S
;   phi            the dart of G that a dart of S stands for (the paper's phi)
;   known          the dart is in S (its vertex is)
;   Turn           numbers of places to turn by
;   turn, unturn   in G: (turn b d) = sigma^b(d), its inverse.  turn_map: the same in S
;   marked, home   at v0, in G and in S
;   bearing        the offset to the dart pointed at, as sensed; expected: as computed in S
;   pointed        the dart that the marker points to, in G; pointed_map: in S
;   h, x           hypothesis and true dart where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-sort Turn 0)
(declare-fun turn (Turn Dart) Dart)
(declare-fun unturn (Turn Dart) Dart)
(declare-fun turn_map (Turn MapDart) MapDart)
(declare-fun phi (MapDart) Dart)
(declare-fun known (MapDart) Bool)
(declare-fun marked (Dart) Bool)
(declare-fun home (MapDart) Bool)
(declare-fun bearing (Dart) Turn)
(declare-fun expected (MapDart) Turn)
(declare-const pointed Dart)
(declare-const pointed_map MapDart)
(declare-const h MapDart)
(declare-const x Dart)

; turning is reversible
(assert (forall ((b Turn) (d Dart)) (= (unturn b (turn b d)) d)))
; what a bearing is, sensed and expected
(assert (forall ((d Dart)) (=> (marked d) (= (turn (bearing d) d) pointed))))
(assert (forall ((e MapDart))
  (=> (and (known e) (home e)) (= (turn_map (expected e) e) pointed_map))))
; I-1: turning in S is turning in G (turns-carried-over); S knows the direction of the marker
(assert (forall ((b Turn) (e MapDart)) (=> (known e) (= (phi (turn_map b e)) (turn b (phi e))))))
(assert (= (phi pointed_map) pointed))
; the test of h matches
(assert (known h))
(assert (home h))
(assert (marked x))
(assert (= (bearing x) (expected h)))

; not: the hypothesis is true
(assert (not (= x (phi h))))
(check-sat)
