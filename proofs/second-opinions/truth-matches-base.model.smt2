; A model of the hypotheses of truth-matches-base.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows v0, where the marker points to a0; h = A1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(declare-datatypes ((Turn 0)) (((zero) (one))))
(declare-datatypes ((Degree 0)) (((two))))
(define-fun below ((x0 Turn) (x1 Degree)) Bool true)
(define-fun turn ((x0 Turn) (x1 Dart)) Dart
  (ite (and (= x0 one) (= x1 a0)) a1 (ite (and (= x0 one) (= x1 a1)) a0
  (ite (and (= x0 one) (= x1 b0)) b1 (ite (and (= x0 one) (= x1 b1)) b0
  (ite (and (= x0 one) (= x1 c0)) c1 (ite (and (= x0 one) (= x1 c1)) c0 x1)))))))
(define-fun turn_map ((x0 Turn) (x1 MapDart)) MapDart
  (ite (and (= x0 one) (= x1 A0)) A1 (ite (and (= x0 one) (= x1 A1)) A0
  (ite (and (= x0 one) (= x1 B0)) B1 (ite (and (= x0 one) (= x1 B1)) B0
  (ite (and (= x0 one) (= x1 C0)) C1 (ite (and (= x0 one) (= x1 C1)) C0 x1)))))))
(define-fun degree ((x Dart)) Degree two)
(define-fun degree_map ((x MapDart)) Degree two)
(define-fun marked ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun home ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun bearing ((x Dart)) Turn (ite (= x a1) one zero))
(define-fun expected ((x MapDart)) Turn (ite (= x A1) one zero))
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun known ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun pointed () Dart a0)
(define-fun pointed_map () MapDart A0)
(define-fun h () MapDart A1)

(assert (forall ((b Turn) (c Turn) (d Dart))
  (=> (and (below b (degree d)) (below c (degree d)) (= (turn b d) (turn c d))) (= b c))))
(assert (forall ((d Dart))
  (=> (marked d) (and (below (bearing d) (degree d)) (= (turn (bearing d) d) pointed)))))
(assert (forall ((e MapDart))
  (=> (and (known e) (home e))
      (and (below (expected e) (degree_map e)) (= (turn_map (expected e) e) pointed_map)))))
(assert (forall ((e MapDart)) (=> (known e) (= (degree_map e) (degree (phi e))))))
(assert (forall ((e MapDart)) (=> (known e) (= (home e) (marked (phi e))))))
(assert (forall ((b Turn) (e MapDart)) (=> (known e) (= (phi (turn_map b e)) (turn b (phi e))))))
(assert (= (phi pointed_map) pointed))
(assert (known h))
(check-sat)
