% SAYREPORT  Writes the page results/report.html of a case.
%
% CALL: STATUS = sayReport (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts; no option is known
%   STATUS  0
%
% Errors: DEcalioc:sayReport:missingFile, where this toolbox has no writePage
%
% See also: commandMain

function status = sayReport (root, folder, args)
  commandOptions (args, struct ());
  if isempty (which ('writePage'))
    error ('DEcalioc:sayReport:missingFile', ...
           ['the page needs the function writePage, which this toolbox ' ...
            'does not have (%s). The numbers are in ' ...
            'results/calibration.json and gap/gap.json.'], ...
           fullfile (root, 'infrastructure', 'report'));
  end
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
  writePage (Case);
  printf ('page  %s\n', fullfile (folder, 'results', 'report.html'));
  status = 0;
end
