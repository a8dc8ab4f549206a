; Without the direction of the marker the key lemma is false
; Says: There are a world, a part S of it, and two different hypotheses with the same motions and
;   the same percepts but for the bearing at the end. (Here every vertex has degree 2.)
; Paper: V, step 2 ('which is not available in the undirected marker case'); III
; Symbols:
;   Dart               the darts of the world G
;   Degree             degrees of vertices, compared only
;   sigma              the next dart clockwise
;   alpha              the other end of the same edge
;   degree, home       the percept without direction: degree, and whether the marker is there
;   explored           the dart's edge is in S
;   pointed            the dart that the marker points to
;   x, y               the two hypotheses
;   a0 .. c1           the darts
; Expected: sat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort Degree 0)
(declare-fun sigma (Dart) Dart)
(declare-fun alpha (Dart) Dart)
(declare-fun degree (Dart) Degree)
(declare-fun home (Dart) Bool)
(declare-fun explored (Dart) Bool)
(declare-const pointed Dart)
(declare-const x Dart)
(declare-const y Dart)
(declare-const a0 Dart)
(declare-const a1 Dart)
(declare-const b0 Dart)
(declare-const b1 Dart)
(declare-const c0 Dart)
(declare-const c1 Dart)

; six darts suffice
(assert (forall ((d Dart)) (or (= d a0) (= d a1) (= d b0) (= d b1) (= d c0) (= d c1))))
; G is a map, here with two darts at each vertex
(assert (forall ((d Dart)) (and (= (sigma (sigma d)) d) (not (= (sigma d) d)))))
(assert (forall ((d Dart)) (and (= (alpha (alpha d)) d) (not (= (alpha d) d)))))
; degree and marker are those of the vertex
(assert (forall ((d Dart))
  (and (= (degree (sigma d)) (degree d)) (= (home (sigma d)) (home d)))))
; the marker is at one vertex and points to a dart there
(assert (home pointed))
(assert (forall ((d Dart)) (=> (home d) (or (= d pointed) (= d (sigma pointed))))))
; S is a part of G: explored darts come in pairs
(assert (forall ((d Dart)) (=> (explored d) (explored (alpha d)))))
; two hypotheses, both open
(assert (not (explored x)))
(assert (not (explored y)))
; motion 1 leads both through S to v0, with the same degrees and the same marks on the way
(assert (explored (sigma x)))
(assert (explored (sigma y)))
(assert (and (= (degree x) (degree y)) (not (home x)) (not (home y))))
(assert (and (home (alpha (sigma x))) (home (alpha (sigma y)))))
; but they are different darts
(assert (not (= x y)))
; only the direction tells them apart: one comes in by the dart pointed at, the other does not
(assert (and (= (alpha (sigma x)) pointed) (not (= (alpha (sigma y)) pointed))))
(check-sat)
