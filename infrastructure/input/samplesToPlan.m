% SAMPLESTOPLAN  How many samples the plan needs besides the runs at hand.
%
% CALL: N = samplesToPlan (DATA, CASE)
%
%   DATA  see newData: the runs that were taken in
%   CASE  see newCase
%   N     CASE.options.numOfSam less the finished rows; 0 where no new run is
%         allowed
%
% See also: GenerateExperPlan, importExisting

function n = samplesToPlan (data, Case)
  atHand = sum (all (isfinite (data.Z), 2));
  n = max (0, Case.options.numOfSam - atHand);
  if Case.options.maxNewRuns == 0
    n = 0;
  end
end

%!test
%! Case.options = struct ('numOfSam', 5, 'maxNewRuns', Inf);
%! data.Z = [1, 2; NaN, 3; 4, 5];
%! assert (samplesToPlan (data, Case), 3);
%! Case.options.maxNewRuns = 0;
%! assert (samplesToPlan (data, Case), 0);
