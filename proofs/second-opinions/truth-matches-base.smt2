; A true hypothesis always matches, base: no motions left
; Says: The percept expected at a dart of S is what the robot senses in the dart that it stands
;   for: degree, marker, and at v0 the bearing.
; Paper: IV, case (3); V, step 2
; Symbols:
;   Dart, MapDart  the darts of the world G; the darts of the map S
;   phi            the dart of G that a dart of S stands for (the paper's phi)
;   known          the dart is in S (its vertex is)
;   Turn, Degree   numbers of places to turn by; degrees of vertices
;   below          (below b n): b is one of the numbers 0 .. n-1
;   turn           in G: (turn b d) = sigma^b(d).  turn_map: the same in S
;   degree, marked, bearing         what is sensed in G
;   degree_map, home, expected      what is expected from S
;   pointed        the dart that the marker points to, in G; pointed_map: in S
;   h              the hypothesis where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-sort Turn 0)
(declare-sort Degree 0)
(declare-fun below (Turn Degree) Bool)
(declare-fun turn (Turn Dart) Dart)
(declare-fun turn_map (Turn MapDart) MapDart)
(declare-fun degree (Dart) Degree)
(declare-fun degree_map (MapDart) Degree)
(declare-fun marked (Dart) Bool)
(declare-fun home (MapDart) Bool)
(declare-fun bearing (Dart) Turn)
(declare-fun expected (MapDart) Turn)
(declare-fun phi (MapDart) Dart)
(declare-fun known (MapDart) Bool)
(declare-const pointed Dart)
(declare-const pointed_map MapDart)
(declare-const h MapDart)

; turns by less than the degree lead to different darts
(assert (forall ((b Turn) (c Turn) (d Dart))
  (=> (and (below b (degree d)) (below c (degree d)) (= (turn b d) (turn c d))) (= b c))))
; what a bearing is, sensed and expected
(assert (forall ((d Dart))
  (=> (marked d) (and (below (bearing d) (degree d)) (= (turn (bearing d) d) pointed)))))
(assert (forall ((e MapDart))
  (=> (and (known e) (home e))
      (and (below (expected e) (degree_map e)) (= (turn_map (expected e) e) pointed_map)))))
; I-1: S carries the degrees and the marker of G, turning in S is turning in G
(assert (forall ((e MapDart)) (=> (known e) (= (degree_map e) (degree (phi e))))))
(assert (forall ((e MapDart)) (=> (known e) (= (home e) (marked (phi e))))))
(assert (forall ((b Turn) (e MapDart)) (=> (known e) (= (phi (turn_map b e)) (turn b (phi e))))))
(assert (= (phi pointed_map) pointed))
; the hypothesis
(assert (known h))

; not: the percept is as expected
(assert (not (and (= (degree_map h) (degree (phi h)))
          (= (home h) (marked (phi h)))
          (=> (home h) (= (expected h) (bearing (phi h)))))))
(check-sat)
