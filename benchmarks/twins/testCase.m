% TESTCASE  Draws a case of the study of next tests from its number.
%
% CALL: [LAB, TWIN] = testCase (KIND, NUMBER)
%
%   KIND, NUMBER  see foreignLab
%   LAB   struct of testsOfLab: all benches, or in every second four cases all
%         but the last, belong to the case
%   TWIN  struct theta, phi (of one cause), cause (its number), d, y (measured
%         values). d is 4, 5, 6 or 8, by an effect that can reach it, if there
%         is one
%
% foreignLab takes its four laws in turn; any 32 numbers in a row hold each law
% with each d, all benches and all but one.
%
% See also: nextTestStudy

function [lab, twin] = testCase (kind, number)
  lab = testsOfLab (kind, number, mod (floor (number / 4), 2));
  rand ('twister', 830000 + number);
  randn ('twister', 830000 + number);
  K = numel (lab.problem.effects);
  p = columns (lab.problem.limits);
  levels = [4, 5, 6, 8];
  level = levels(1 + mod (floor (number / 8), 4));
  twin = struct ('theta', 0.1 + 0.8 * rand (1, p), 'phi', zeros (1, K));
  lab.noise = sqrt (lab.noiseSd.^2 + lab.problem.sd.^2);
  space = twinsSpace (lab, twin.theta);
  order = strongFirst (randperm (K), lab, space, twin.theta, level);
  twin.cause = order(1);
  twin.phi(twin.cause) = twinsStrength (lab, space, twin.cause, level);
  twin.d = space.visible (lab.means (twin.theta, twin.phi) - space.base);
  twin.y = lab.measure (twin.theta, twin.phi);
end
