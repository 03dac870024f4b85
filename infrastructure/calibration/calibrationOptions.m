% CALIBRATIONOPTIONS  Options and thresholds of a calibration, with reasons.
%
% CALL: OPTIONS = calibrationOptions (GIVEN)
%
%   GIVEN    scalar struct of what the case says (Case.options); may be empty
%   OPTIONS  the same with all fields; by default
%     sets 1, seed 1, maxFunEvals 40, maxIter 3, tolfun 0.002, replicates 1,
%     WRL 0, method 'robust', infill 'thompson', confidence 0.95: see
%     docs/inputs.md
%   and of the method
%     likely     0.8    probability that ends the infill: the runs that confirm
%                       the set bring the rest up to the confidence
%     unsure     0.9    below it as many runs at once confirm a set as can go
%     even       0.5    from here on the runs of an infill go to the found set
%                       alone, and preferences may choose among sets
%     wrong      0.2    a set less probable than this has turned out wrong
%     better     0.02   by which another set must be likelier: less is within
%                       what two fits of the same runs differ
%     apart      3      standard errors at which runs contradict a tolerance or
%                       their surrogate: chance 0.3 %
%     conflicts  2      rounds in which no set may meet all before it is said:
%                       a round of runs may show a way
%     atLimit    0.005  of the box: nearer to its wall a parameter stands at it
%     loose      0.5    of the box: a wider interval does not identify
%     direct     0.05   of the box: how well a parameter measures by itself
%     planShare  2/3    of the plan that must succeed: else box or model is at
%                       fault

function options = calibrationOptions (given)
  options = struct ('sets', 1, 'seed', 1, 'maxFunEvals', 40, ...
                    'maxIter', 3, 'tolfun', 0.002, 'replicates', 1, ...
                    'WRL', 0, 'method', 'robust', 'infill', 'thompson', ...
                    'confidence', 0.95, ...
                    'likely', 0.8, 'unsure', 0.9, 'even', 0.5, ...
                    'wrong', 0.2, 'better', 0.02, 'apart', 3, ...
                    'conflicts', 2, 'atLimit', 0.005, 'loose', 0.5, ...
                    'direct', 0.05, 'planShare', 2 / 3);
  if ~isempty (given)
    options = mergeFields (options, given);
  end
end

%!test
%! o = calibrationOptions (struct ('maxIter', 7));
%! assert ([o.maxIter, o.maxFunEvals, o.likely], [7, 40, 0.8]);
%! assert (calibrationOptions ([]).maxIter, 3);
