% GAPOPTIONS  Fills the options of a diagnosis with their defaults.
%
% CALL: OPTIONS = gapOptions (GIVEN)
%
%   GIVEN    struct with any of the fields ([] = all defaults)
%   OPTIONS  struct with all of them
%     seed         random numbers start here (1)
%     points       first draw of each integral (400), effective points wanted
%                  (400) and most points drawn (12000): points, effective, most
%     bootstrap    repetitions of the fit test (999)
%     twins        twins without a gap, drawn from the surrogates, that the gate
%                  compares with (400)
%     trials       twins with a known cause that tell how often the verdict is
%                  right (160; 0 = none)
%     covariance   of the baseline Kriging ('matern52'; 'choose' tries more)
%     trend        of the same ('choose')
%     maxNewRuns   DEM runs that the diagnosis may spend in all (0)
%     screenRuns   runs an effect gets for screening (4)
%     survivors    effects that get a plan of their own (3)
%     planRuns     runs a survivor has in the end ([]: 5 (p + 1))
%     verifyRuns   seeds at each compared set when the cure is checked (5)
%   and what a verdict needs, see judgeCase:
%     level        chance of a false alarm (0.05)
%     surplus      variance of data without a gap over what the budget says
%                  (1.15; at 1 laboratories of formulas alarm in 9 %)
%     caution      power of the likelihood in intervals of strengths (0.6: at 1
%                  they hold the strength of left-out LIGGGHTS runs of
%                  hiddenEffect in 76 % where they should in 90 %)
%     nameAt       probability at which a cause is named or a group given (0.8):
%                  two wrong ones in ten would be too many, and the calibrated
%                  precision at 0.8 is above 0.95 (docs/gap.md)
%     exclude      Bayes factor against a look-alike of cosine 0.9 that a name
%                  alone needs (3: "positive" of Kass and Raftery 1995)
%     leastPoints  effective points below which no number is believed (200: an
%                  error of 0.07 in the logarithm of the evidence)
%
% See also: diagnoseMatrices

function options = gapOptions (given)
  options = struct ('seed', 1, 'points', 400, 'effective', 400, ...
                    'most', 12000, 'bootstrap', 999, 'twins', 400, ...
                    'trials', 160, 'covariance', 'matern52', ...
                    'trend', 'choose', 'maxNewRuns', 0, 'screenRuns', 4, ...
                    'survivors', 3, 'planRuns', [], 'verifyRuns', 5, ...
                    'level', 0.05, 'nameAt', 0.8, 'exclude', 3, ...
                    'leastPoints', 200, 'surplus', 1.15, 'caution', 0.6);
  if isstruct (given)
    fields = fieldnames (given);
    for k = 1:numel (fields)
      options.(fields{k}) = given.(fields{k});
    end
  end
end

%!assert (gapOptions ([]).level, 0.05)
%!assert (gapOptions (struct ('nameAt', 0.9)).nameAt, 0.9)
