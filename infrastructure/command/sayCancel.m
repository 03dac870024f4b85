% SAYCANCEL  Ends the runs of a case and says what was ended.
%
% CALL: STATUS = sayCancel (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts; no option is known
%   STATUS  0
%
% See also: cancelCase, commandMain

function status = sayCancel (root, folder, args)
  commandOptions (args, struct ());
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
  done = cancelCase (Case);
  words = {'no Octave worked in it', 'its Octave was ended'};
  printf ('%s; %d run(s) ended here, %d job array(s) on Slurm\n', ...
          words{1 + done.octave}, done.runs, done.arrays);
  printf ('Finished runs are kept; decalioc run goes on.\n');
  status = 0;
end
