% GAPOPTIONS  Fills the options of a diagnosis with their defaults.
%
% CALL: OPTIONS = gapOptions (GIVEN)
%
%   GIVEN    struct with any of the fields ([] = all defaults)
%   OPTIONS  struct with all of them
%     seed         random numbers start here (1)
%     level        chance of a false alarm (0.05)
%     nameAt       least probability at which a cause is named (0.8)
%     draws        points of each numerical integration (1000)
%     bootstrap    repetitions of the fit test (999)
%     twins        twins drawn from the surrogates that calibrate the verdict
%                  (160; 0 = none, temperature and thresholds as given)
%     temperature  start value, P ~ prior * exp (log evidence / temperature) (1)
%     covariance   of the baseline Kriging ('matern52'; 'choose' tries more)
%     trend        of the same ('choose')
%     maxNewRuns   DEM runs that the diagnosis may spend in all (0)
%     screenRuns   runs an effect gets for screening (4)
%     survivors    effects that get a plan of their own (3)
%     planRuns     runs a survivor has in the end ([]: 5 (p + 1))
%     verifyRuns   seeds at each compared set when the cure is checked (5)
%
% See also: diagnoseMatrices

function options = gapOptions (given)
  options = struct ('seed', 1, 'level', 0.05, 'nameAt', 0.8, 'draws', 1000, ...
                    'bootstrap', 999, 'twins', 160, 'temperature', 1, ...
                    'covariance', 'matern52', 'trend', 'choose', ...
                    'maxNewRuns', 0, ...
                    'screenRuns', 4, 'survivors', 3, 'planRuns', [], ...
                    'verifyRuns', 5);
  if isstruct (given)
    fields = fieldnames (given);
    for k = 1:numel (fields)
      options.(fields{k}) = given.(fields{k});
    end
  end
end

%!assert (gapOptions ([]).level, 0.05)
%!assert (gapOptions (struct ('draws', 7)).draws, 7)
