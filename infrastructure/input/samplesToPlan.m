% SAMPLESTOPLAN  How many samples the plan needs besides the runs at hand.
%
% CALL: N = samplesToPlan (DATA, CASE)
%
%   DATA  see newData: the runs that were taken in
%   CASE  see newCase
%   N     CASE.options.numOfSam less the finished rows; 0 where there is no
%         model to run
%
% See also: GenerateExperPlan, importExisting

function n = samplesToPlan (data, Case)
  atHand = sum (all (isfinite (data.Z), 2));
  n = max (0, Case.options.numOfSam - atHand);
  if any (cellfun (@isempty, {Case.models.folder}))
    n = 0;
  end
end

%!test
%! Case.options.numOfSam = 5;
%! Case.models = struct ('folder', {'a', 'b'});
%! data.Z = [1, 2; NaN, 3; 4, 5];
%! assert (samplesToPlan (data, Case), 3);
%! Case.models(2).folder = '';
%! assert (samplesToPlan (data, Case), 0);
